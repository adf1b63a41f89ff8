#include <gmock/gmock.h>

#include "renderer/error.h"
#include "renderer/scene/scene.h"

namespace guidelight {
namespace {

std::string error_of(const SceneDescription& description) {
  try {
    Scene::build(std::make_shared<SceneDescription>(description));
    return "";
  } catch (const Error& error) {
    return error.what();
  }
}

/// A shape of which its transform leaves nothing.
ShapeDescription collapsed(const char* name, int line,
                           decltype(ShapeDescription::geometry) geometry) {
  ShapeDescription shape;
  shape.name = name;
  shape.line = line;
  shape.geometry = std::move(geometry);
  shape.to_world = Mat4(0);
  return shape;
}

TEST(SceneBuilder, ErrorsNameTheFileOfTheScene) {
  SceneDescription sound;
  sound.path = "room.xml";
  EXPECT_EQ(error_of(sound), "");

  SceneDescription scene = sound;
  scene.shapes = {collapsed("ball", 7, SphereShape{})};
  EXPECT_THAT(error_of(scene), testing::StartsWith("room.xml: Shape 'ball' (line 7)"));

  scene = sound;
  scene.groups.push_back({.name = "g", .line = 1, .shapes = {}});
  scene.shapes = {collapsed("copy", 8, InstanceShape{0})};
  EXPECT_THAT(error_of(scene), testing::StartsWith("room.xml:8: "));

  scene = sound;
  scene.emitters.push_back({.name = "sky", .line = 9, .model = EnvironmentEmitter{}});
  EXPECT_THAT(error_of(scene), testing::StartsWith("room.xml: line 9: emitter 'sky'"));

  scene = sound;
  scene.film.crop_width = 9999;
  EXPECT_THAT(error_of(scene), testing::StartsWith("room.xml: the crop window"));

  scene.path.clear();
  EXPECT_THAT(error_of(scene), testing::StartsWith("the crop window"));
}

}  // namespace
}  // namespace guidelight

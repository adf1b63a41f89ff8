#include <gmock/gmock.h>

#include <glm/gtc/matrix_transform.hpp>

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
  EXPECT_THAT(error_of(scene), ::testing::StartsWith("room.xml: Shape 'ball' (line 7)"));

  scene = sound;
  scene.groups.push_back({.name = "g", .line = 1, .shapes = {}});
  scene.shapes = {collapsed("copy", 8, InstanceShape{0})};
  EXPECT_THAT(error_of(scene), ::testing::StartsWith("room.xml:8: "));

  scene = sound;
  scene.emitters.push_back({.name = "sky", .line = 9, .model = EnvironmentEmitter{}});
  EXPECT_THAT(error_of(scene), ::testing::StartsWith("room.xml: line 9: emitter 'sky'"));

  scene = sound;
  scene.film.crop_width = 9999;
  EXPECT_THAT(error_of(scene), ::testing::StartsWith("room.xml: the crop window"));

  scene.path.clear();
  EXPECT_THAT(error_of(scene), ::testing::StartsWith("the crop window"));
}

TEST(SceneBuilder, SharedMeshesCountOnceAndWhole) {
  Mesh mesh;
  mesh.positions.assign(100000, Vec3(0));
  mesh.positions[1] = {1, 0, 0};
  mesh.positions[2] = {0, 1, 0};
  mesh.normals.assign(100000, Vec3(0, 0, 1));
  mesh.uvs.assign(100000, Vec2(0));
  mesh.triangles = {{0, 1, 2}};
  const size_t shared = 100000 * (2 * sizeof(Vec3) + sizeof(Vec2));
  const size_t own = 100000 * sizeof(Vec3);  // positions in world space; the normals are flat
  SceneDescription scene;
  scene.shapes.resize(1);
  scene.shapes[0].geometry = MeshShape{std::make_shared<const Mesh>(mesh)};
  const auto bytes = [&] {
    return static_cast<double>(
        Scene::build(std::make_shared<SceneDescription>(scene))->statistics().bytes);
  };
  const double small = 0.05 * static_cast<double>(shared);
  EXPECT_NEAR(bytes(), static_cast<double>(shared + own), small);
  scene.shapes.resize(3, scene.shapes[0]);
  EXPECT_NEAR(bytes(), static_cast<double>(shared + 3 * own), small);
}

/// A shape, light or camera so far away that rays to it are no rays any more.
TEST(SceneBuilder, WhatIsTooFarAwayIsNamed) {
  const Mat4 far = glm::translate(Mat4(1), Vec3(0, 2e9f, 0));
  ShapeDescription ball;
  ball.name = "ball";
  ball.geometry = SphereShape{};
  for (const Mat4& to_world : {far, glm::scale(Mat4(1), Vec3(1e20f))}) {
    for (const auto& geometry :
         {decltype(ball.geometry)(SphereShape{}), decltype(ball.geometry)(DiskShape{}),
          decltype(ball.geometry)(CylinderShape{})}) {
      SceneDescription scene;
      scene.shapes = {ball};
      scene.shapes[0].geometry = geometry;
      scene.shapes[0].to_world = to_world;
      EXPECT_THAT(error_of(scene), ::testing::HasSubstr("'ball' reaches farther than 1000000000"));
    }
  }

  SceneDescription instanced;
  instanced.groups.push_back({.name = "balls", .line = 1, .shapes = {ball}});
  instanced.shapes = {ball};
  instanced.shapes[0].geometry = InstanceShape{0};
  EXPECT_EQ(error_of(instanced), "");
  instanced.shapes[0].to_world = far;
  EXPECT_THAT(error_of(instanced), ::testing::HasSubstr("instance of 'balls' reaches farther"));
  instanced.shapes[0].to_world = glm::scale(Mat4(1), Vec3(1e-12f));
  EXPECT_THAT(error_of(instanced), ::testing::HasSubstr("the instance 'ball' is too small"));

  SpotEmitter spot;
  spot.to_world = far;
  for (const auto& model : {decltype(EmitterDescription::model)(PointEmitter{Vec3(1e19f, 0, 0)}),
                            decltype(EmitterDescription::model)(PointEmitter{Vec3(0, NAN, 0)}),
                            decltype(EmitterDescription::model)(spot)}) {
    SceneDescription scene;
    scene.emitters.push_back({.name = "lamp", .line = 3, .model = model});
    EXPECT_THAT(error_of(scene),
                ::testing::HasSubstr("emitter 'lamp': it is not finite or farther"));
  }
}

}  // namespace
}  // namespace guidelight

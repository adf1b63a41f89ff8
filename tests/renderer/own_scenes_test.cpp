// The scenes in scenes/ open without a warning and show what their comments promise.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "renderer/image/metrics.h"
#include "renderer/io/guide_file.h"
#include "renderer/io/scene_file.h"
#include "renderer/transport/guide_check.h"
#include "tests/renderer/test_scenes.h"

namespace guidelight {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> own_scenes() {
  const fs::path root = fs::path(GUIDELIGHT_SOURCE_DIR) / "scenes";
  std::vector<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(root)) {
    if (entry.path().filename() == "scene.xml") {
      names.push_back(entry.path().parent_path().lexically_relative(root).string());
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

SceneDescription read_own(const std::string& name) {
  return read_scene(GUIDELIGHT_SOURCE_DIR "/scenes/" + name + "/scene.xml");
}

Image picture_of(const std::string& name, uint32_t passes) {
  return testing::render(testing::build(read_own(name)), passes).develop(Layer::Beauty);
}

/// Mean over the pixels [x, x + size)².
Color block_mean(const Image& image, int x, int y, int size) {
  Color sum(0);
  for (int j = y; j < y + size; ++j) {
    for (int i = x; i < x + size; ++i) sum += image.color(i, j);
  }
  return sum / static_cast<float>(size * size);
}

class OwnScene : public ::testing::TestWithParam<std::string> {};

TEST_P(OwnScene, opens_without_warnings_and_is_lit) {
  SceneDescription scene = read_own(GetParam());
  EXPECT_THAT(scene.warnings, ::testing::IsEmpty());
  scene.film.width = scene.film.height = 64;
  const Film film = testing::render(testing::build(scene), 4);
  EXPECT_EQ(film.rejected(), 0u);
  const float brightness = luminance(mean_color(film.develop(Layer::Beauty)));
  EXPECT_GT(brightness, 0.02f);
  EXPECT_LT(brightness, 4);
}

INSTANTIATE_TEST_SUITE_P(All, OwnScene, ::testing::ValuesIn(own_scenes()), [](const auto& scene) {
  std::string name = scene.param;
  std::replace_if(
      name.begin(), name.end(), [](char c) { return !std::isalnum(c); }, '_');
  return name;
});

TEST_P(OwnScene, has_guides_that_fit) {
  const std::string file =
      guide_file_beside(GUIDELIGHT_SOURCE_DIR "/scenes/" + GetParam() + "/scene.xml");
  if (!fs::exists(file)) return;
  const auto scene = testing::build(read_own(GetParam()));
  for (const GuidePath& guide : read_guides(file)) {
    EXPECT_TRUE(guide.enabled) << guide.name;
    for (const GuideFault& fault : check_guide(*scene, guide)) {
      ADD_FAILURE() << guide.name << ", vertex " << fault.vertex << ": " << fault.message;
    }
  }
}

TEST(OwnScenes, guides_go_where_they_are_needed) {
  const auto guides_of = [](const std::string& name) {
    return read_guides(GUIDELIGHT_SOURCE_DIR "/scenes/" + name + "/scene.guides.json");
  };
  const auto rooms = guides_of("rooms");
  EXPECT_EQ(rooms.size(), 10u);
  for (const GuidePath& guide : rooms) {
    EXPECT_LT(guide.vertices.front().position.z, -2.05f) << guide.name << " starts in the far room";
    EXPECT_GT(guide.vertices.back().position.z, -2) << guide.name << " ends in the near one";
  }
  const auto box = guides_of("box");
  EXPECT_EQ(box.size(), 10u);
  for (const GuidePath& guide : box) {
    const bool by_the_mirror = guide.vertices[1].event == PathEvent::Reflect;
    const Vec3 caustic(by_the_mirror ? -0.09f : 0.44f, 0, 0.52f);
    EXPECT_LT(glm::distance(guide.vertices.back().position, caustic), 0.12f) << guide.name;
    EXPECT_NEAR(guide.vertices[0].cone, glm::radians(by_the_mirror ? 1.0f : 5.0f), 1e-6f);
  }
  EXPECT_EQ(
      std::ranges::count_if(box, [](const GuidePath& guide) { return guide.vertices.size() == 5; }),
      5);
  // Through the hole, or to the wall of the corridor that shines through it.
  const auto keyhole = guides_of("keyhole");
  const auto in_room = std::ranges::count_if(
      keyhole, [](const GuidePath& guide) { return guide.vertices.back().position.x > -1.4f; });
  EXPECT_GE(in_room, 4);
  for (const GuidePath& guide : keyhole) {
    const bool in_corridor = guide.vertices.back().position.x < -1.47f;
    EXPECT_TRUE(in_corridor || guide.vertices.back().position.x > -1.4f) << guide.name;
  }
  for (const GuidePath& guide : guides_of("lantern")) {
    EXPECT_GT(glm::distance(guide.vertices.back().position, Vec3(0, 0.85f, 0)), 0.5f)
        << guide.name << " leaves the lantern";
  }
}

TEST(OwnScenes, furnace_hides_its_spheres) {
  // Nothing absorbs, so L = 1 everywhere. The noise of a block's mean is below 0.5 % (measured).
  const Image image = picture_of("furnace", 64);
  for (int y = 0; y < image.height(); y += 16) {
    for (int x = 0; x < image.width(); x += 16) {
      EXPECT_NEAR(luminance(block_mean(image, x, y, 16)), 1, 0.03) << "at " << x << ", " << y;
    }
  }
}

TEST(OwnScenes, grey_ball_in_the_furnace_shows_its_albedo) {
  const Image image = picture_of("tests/furnace-grey", 64);
  EXPECT_NEAR(luminance(block_mean(image, 56, 56, 16)), 0.5, 0.01);
  EXPECT_NEAR(luminance(block_mean(image, 0, 0, 16)), 1, 1e-5);
}

TEST(OwnScenes, normal_map_makes_bumps) {
  // A flat wall without its map would be uniform under a directional light.
  const Image image = picture_of("tests/normal-map", 16);
  float darkest = kInfinity;
  float brightest = 0;
  for (int y = 48; y < 80; ++y) {
    for (int x = 48; x < 80; ++x) {
      darkest = std::min(darkest, luminance(image.color(x, y)));
      brightest = std::max(brightest, luminance(image.color(x, y)));
    }
  }
  EXPECT_GT(brightest, 2 * darkest);
}

TEST(OwnScenes, absorbing_glass_is_green) {
  const Color ball = block_mean(picture_of("tests/absorbing-glass", 64), 52, 44, 24);
  EXPECT_GT(ball.g, 1.5f * ball.r);
  EXPECT_GT(ball.g, 1.2f * ball.b);
}

}  // namespace
}  // namespace guidelight

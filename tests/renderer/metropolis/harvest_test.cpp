#include "renderer/metropolis/harvest.h"

#include <gtest/gtest.h>

#include "renderer/transport/guide_check.h"
#include "tests/renderer/comparison_scenes.h"
#include "tests/renderer/test_scenes.h"

namespace guidelight {
namespace {

TEST(Harvest, finds_the_ways_of_light_as_guides) {
  for (const auto& comparison : testing::comparison_scenes({"point_light", "mirror_glass_box"})) {
    const auto scene = testing::build(comparison.make());
    const auto found = harvest(*scene, PixelRegion{20, 40, 30, 50}, 20000, 8, false);
    ASSERT_FALSE(found.empty()) << comparison.name;
    double sum = 0;
    for (size_t i = 0; i < found.size(); ++i) {
      EXPECT_TRUE(check_guide(*scene, found[i].guide).empty())
          << comparison.name << ", " << found[i].guide.name;
      EXPECT_LE(found[i].share, found[i > 0 ? i - 1 : 0].share);
      sum += found[i].share;
    }
    EXPECT_GT(sum, 0.2) << comparison.name;
    EXPECT_LE(sum, 1 + 1e-9) << comparison.name;
  }
}

TEST(Harvest, direct_light_is_the_strongest_way_to_an_open_floor) {
  const auto scene = testing::build(testing::comparison_scenes({"point_light"})[0].make());
  const auto found = harvest(*scene, PixelRegion::pixel({32, 60}), 20000, 3, false);
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found[0].guide.vertices.size(), 2u);
  EXPECT_NEAR(found[0].guide.vertices[0].position.y, 0.6, 1e-6);
}

TEST(Harvest, stops_when_told_to) {
  const auto scene = testing::build(testing::room());
  EXPECT_TRUE(harvest(*scene, PixelRegion::pixel({4, 4}), 1000000000, 3, true).empty());
}

}  // namespace
}  // namespace guidelight

#include "renderer/metropolis/harvest.h"

#include <gtest/gtest.h>

#include "renderer/image/metrics.h"
#include "renderer/metropolis/pilot.h"
#include "renderer/transport/guide_check.h"
#include "renderer/transport/guide_mixture.h"
#include "tests/renderer/comparison_scenes.h"
#include "tests/renderer/test_scenes.h"
#include "tests/statistics/hypothesis_tests.h"

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

/// Means of short pictures of chains.
statistics::Moments means_of_chains(std::shared_ptr<const Scene> scene,
                                    std::shared_ptr<const GuideMixture> guides) {
  const IntegratorInfo& info = find_integrator("mlt");
  const auto settings = info.make_settings(scene->description().hints);
  set_parameter(*settings, "guided", "0.3");
  set_parameter(*settings, "seed_paths", "10000");
  Parallel parallel(2);
  statistics::Moments means;
  for (uint64_t seed = 0; seed < 12; ++seed) {
    Film film(testing::kComparisonSide, testing::kComparisonSide, scene->camera().film().filter);
    PassContext context{.seed = seed, .parallel = &parallel};
    context.guides = guides;
    info.create(scene, *settings)->render_pass(0, film, context);
    means.add(luminance(mean_color(film.develop(Layer::Beauty))));
  }
  return means;
}

TEST(Pilot, guides_fit_the_scene_and_leave_the_picture_as_it_was) {
  const auto scene = testing::build(testing::comparison_scenes({"mirror_glass_box"})[0].make());
  const auto found = pilot_guides(*scene, 100000, 6, false);
  ASSERT_EQ(found.size(), 6u);
  std::vector<GuidePath> guides;
  bool has_caustic = false;
  for (const HarvestedPath& path : found) {
    EXPECT_TRUE(check_guide(*scene, path.guide).empty()) << path.guide.name;
    has_caustic |= path.guide.vertices[1].event != PathEvent::Scatter;
    guides.push_back(path.guide);
  }
  EXPECT_TRUE(has_caustic);
  const auto without = means_of_chains(scene, nullptr);
  const auto with = means_of_chains(scene, GuideMixture::build(scene, guides));
  EXPECT_GT(statistics::welch_test(with, without), statistics::kFalseAlarms)
      << with.mean() << " +- " << with.standard_error() << " against " << without.mean() << " +- "
      << without.standard_error();
  EXPECT_LT(with.standard_error(), 0.03 * with.mean());
}

TEST(Pilot, finds_nothing_when_told_to_stop) {
  const auto scene = testing::build(testing::room());
  EXPECT_TRUE(pilot_guides(*scene, 1000000000, 3, true).empty());
}

}  // namespace
}  // namespace guidelight

#include "renderer/metropolis/bidirectional_sampler.h"

#include <gtest/gtest.h>

#include "tests/renderer/comparison_scenes.h"
#include "tests/renderer/test_scenes.h"
#include "tests/statistics/hypothesis_tests.h"

namespace guidelight {
namespace {

using statistics::Moments;
using testing::ComparisonScene;

constexpr double kFalseAlarms = 1e-3;

class WholePaths : public ::testing::TestWithParam<ComparisonScene> {};

/// The mean of the picture is the integral of f over all paths: that of target / density of paths
/// of every kind, and that of the path tracer, agree.
TEST_P(WholePaths, IntegrateToThePicture) {
  const auto scene = testing::build(GetParam().make());
  Moments expected;
  for (uint64_t seed = 1; seed <= 8; ++seed) {
    expected.add(
        luminance(testing::mean_color(testing::render(scene, 8, 2, seed).develop(Layer::Beauty))));
  }
  const PathSampler sampler(*scene, {1, 6});
  Path path;
  Moments found;
  constexpr int kPaths = 20000;
  for (int batch = 0; batch < 20; ++batch) {
    double sum = 0;
    for (int i = 0; i < kPaths; ++i) {
      Rng rng(7, batch, i);
      if (const double pdf = sampler.sample(path, rng); pdf > 0) sum += path.target() / pdf;
    }
    found.add(sum / kPaths);
  }
  const double level = statistics::sidak_level(kFalseAlarms, testing::comparison_scenes().size());
  EXPECT_GT(statistics::welch_test(found, expected), level)
      << found.mean() << " +- " << found.standard_error() << " against " << expected.mean()
      << " +- " << expected.standard_error();
  EXPECT_LT(found.standard_error(), 0.03 * found.mean());
}

INSTANTIATE_TEST_SUITE_P(Scenes, WholePaths, ::testing::ValuesIn(testing::comparison_scenes()),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace guidelight

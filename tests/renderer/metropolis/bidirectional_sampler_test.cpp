#include "renderer/metropolis/bidirectional_sampler.h"

#include <gtest/gtest.h>

#include "renderer/image/metrics.h"
#include "tests/renderer/comparison_scenes.h"
#include "tests/renderer/test_scenes.h"
#include "tests/statistics/hypothesis_tests.h"

namespace guidelight {
namespace {

using statistics::Moments;
using testing::ComparisonScene;

/// How much of what arrives at a raster position the pixels of the picture take: less than 1 near
/// the edges, and more than 0 a little beyond them.
double share_of_picture(const Filter& filter, const Camera& camera, Vec2 raster) {
  double share = 0;
  const auto reach = static_cast<int>(std::ceil(filter.radius()));
  const glm::ivec2 middle(glm::floor(raster));
  for (int y = std::max(0, middle.y - reach); y < std::min(camera.height(), middle.y + reach + 1);
       ++y) {
    for (int x = std::max(0, middle.x - reach); x < std::min(camera.width(), middle.x + reach + 1);
         ++x) {
      share += filter.eval(raster - Vec2(x, y) - 0.5f);
    }
  }
  return share;
}

class WholePaths : public ::testing::TestWithParam<ComparisonScene> {};

/// The mean of the picture is the integral of f over all paths: that of target / density of paths
/// of every kind, and that of the path tracer, agree.
TEST_P(WholePaths, IntegrateToThePicture) {
  const auto scene = testing::build(GetParam().make());
  Moments expected;
  for (uint64_t seed = 1; seed <= 8; ++seed) {
    expected.add(luminance(mean_color(testing::render(scene, 8, 2, seed).develop(Layer::Beauty))));
  }
  const PathSampler sampler(*scene, {1, 6});
  const Filter filter(scene->camera().film().filter);
  Path path;
  Moments found;
  constexpr int kPaths = 20000;
  for (int batch = 0; batch < 20; ++batch) {
    double sum = 0;
    for (int i = 0; i < kPaths; ++i) {
      Rng rng(7, batch, i);
      const double pdf = sampler.sample(path, rng);
      if (!(pdf > 0)) continue;
      sum += path.target() / pdf * share_of_picture(filter, scene->camera(), path.raster);
    }
    found.add(sum / kPaths);
  }
  const double level =
      statistics::sidak_level(statistics::kFalseAlarms, testing::comparison_scenes().size());
  EXPECT_GT(statistics::welch_test(found, expected), level)
      << found.mean() << " +- " << found.standard_error() << " against " << expected.mean()
      << " +- " << expected.standard_error();
  EXPECT_LT(found.standard_error(), 0.03 * found.mean());
}

TEST(BackgroundPaths, IntegrateToItsRadiance) {
  for (const Vec3 target : {Vec3(1, 0.2f, 0.1f), Vec3(0, 0, 1)}) {
    for (const CameraModel model : {CameraModel::Perspective, CameraModel::Orthographic}) {
      SceneDescription description = testing::empty_scene(16, 16);
      description.emitters.push_back({"sky", 0, ConstantEmitter{Color(0.5f)}});
      testing::look_at(description, Vec3(0), target);
      description.camera.model = model;
      const auto scene = testing::build(description);
      const PathSampler sampler(*scene, {1, 1});
      Path path;
      Moments found;
      for (int i = 0; i < 10000; ++i) {
        Rng rng(7, 0, i);
        const double pdf = sampler.sample(path, rng);
        found.add(pdf > 0 ? path.target() / pdf : 0);
      }
      EXPECT_NEAR(found.mean(), 0.5, 5 * found.standard_error());
      EXPECT_LT(found.standard_error(), 0.01);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, WholePaths, ::testing::ValuesIn(testing::comparison_scenes()),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace guidelight

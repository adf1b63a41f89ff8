// All integrators show the same picture: independent runs of each against independent runs of the
// path tracer, by Welch's t-test of the means of 32×32 blocks and of the whole picture. The seeds
// are fixed; a correct renderer would fail any of the tests of this file with probability 1e-3.

#include <gtest/gtest.h>

#include "tests/renderer/comparison_scenes.h"
#include "tests/renderer/integrators/independent_runs.h"
#include "tests/renderer/test_scenes.h"

namespace guidelight {
namespace {

using statistics::Moments;
using testing::ComparisonScene;
using testing::Method;

const testing::Runs kAgreementRuns{.count = 10, .first_seed = 1000, .block = 32};

/// Methods without bias, and those whose radius is so small that their bias is far below the noise;
/// photon maps have one camera sample for that, whose noise is larger.
std::vector<Method> methods(const ComparisonScene& scene) {
  std::vector<Method> list = {
      {"bdpt", "", 6},
      {"bdpt", "connect_to=random_vertices", 6},
      {"vcm", "scene_radius=0.3,alpha=1", 6},
      {"vcm", "scene_radius=0.3,alpha=1,merge_direct=true", 6},
      {"vcm", "lean=true,radius_from=pixel,pixel_radius=1", 6},
      {"bpm", "scene_radius=0.5,alpha=1,light_paths=2", 6},
      {"bdpm", "scene_radius=1,neighbors=10,light_paths=2", 6},
      {"pppm", "scene_radius=0.5,alpha=1,light_paths=2", 6},
      {"ppm", "scene_radius=0.5,light_paths=2", 6},
      {"sppm", "scene_radius=0.5,light_paths=2", 6},
      {"photon_map", "light_paths=30000,neighbors=20,gather_rays=30,camera_samples=1", 3},
      {"photon_map",
       "light_paths=30000,neighbors=20,gather_rays=4,irradiance_cache=false,camera_samples=1", 3},
  };
  if (scene.is_diffuse) {
    list.push_back({"light", "", 8});
    list.push_back({"bdpt", "light_paths=0.5,emission=false", 6});
  }
  return list;
}

/// Those with Markov chains, whose runs are less alike.
std::vector<Method> metropolis_methods() {
  return {{"mlt", "mutations=8", 6}, {"pssmlt", "mutations=8", 6}};
}

class Agreement : public ::testing::TestWithParam<ComparisonScene> {
 protected:
  /// `bias` is allowed for, relative to each mean.
  static void compare_with_path_tracer(const std::vector<Method>& tried, double bias = 0);
};

void Agreement::compare_with_path_tracer(const std::vector<Method>& tried, double bias) {
  const auto scene = testing::build(GetParam().make());
  const std::vector<Moments> expected = measure(scene, {"path", "", 32}, kAgreementRuns);
  const double level =
      statistics::sidak_level(statistics::kFalseAlarms,
                              testing::comparison_scenes().size() * tried.size() * expected.size());
  for (const Method& method : tried) {
    const std::vector<Moments> found = measure(scene, method, kAgreementRuns);
    for (size_t i = 0; i < found.size(); ++i) {
      EXPECT_GT(statistics::welch_test(found[i], expected[i], bias * expected[i].mean()), level)
          << method.name << " " << method.parameters << ", block " << i << ": "
          << testing::describe(found[i], expected[i]);
    }
    // A test that compares noise with noise proves nothing.
    EXPECT_LT(found.back().standard_error(), 0.02 * found.back().mean()) << method.name;
  }
}

TEST_P(Agreement, WithThePathTracer) { compare_with_path_tracer(methods(GetParam())); }
TEST_P(Agreement, OfChainsWithThePathTracer) { compare_with_path_tracer(metropolis_methods()); }

INSTANTIATE_TEST_SUITE_P(Scenes, Agreement, ::testing::ValuesIn(testing::comparison_scenes()),
                         [](const auto& test) { return test.param.name; });

/// Diffuse rooms, a caustic box, glossy glass, normal maps.
class MetropolisPhotonsAgreement : public Agreement {};

/// The radius of a round is finite.
TEST_P(MetropolisPhotonsAgreement, WithThePathTracer) {
  compare_with_path_tracer(
      {{"mps",
        "mutations=50000,light_paths=20000,importance_paths=50000,neighbors=30,gather_rays=40", 2}},
      0.01);
}

INSTANTIATE_TEST_SUITE_P(Scenes, MetropolisPhotonsAgreement,
                         ::testing::ValuesIn(testing::comparison_scenes(
                             {"cornell_box", "mirror_glass_box", "sun", "point_light",
                              "rough_dielectric", "normal_map"})),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace guidelight

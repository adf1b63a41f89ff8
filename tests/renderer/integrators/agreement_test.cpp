// All integrators show the same picture: independent runs of each against independent runs of the
// path tracer, by Welch's t-test of the means of 32×32 blocks and of the whole picture. The seeds
// are fixed; a correct renderer would fail any of the tests of this file with probability 1e-3.

#include <gtest/gtest.h>

#include "renderer/integrators/integrator.h"
#include "tests/renderer/comparison_scenes.h"
#include "tests/renderer/test_scenes.h"
#include "tests/statistics/hypothesis_tests.h"

namespace guidelight {
namespace {

using statistics::Moments;
using testing::ComparisonScene;

constexpr int kSide = testing::kComparisonSide;
constexpr int kBlock = 32;
constexpr int kRuns = 10;
constexpr double kFalseAlarms = 1e-3;

/// Means over blocks, and last over the picture, of one run.
std::vector<double> block_means(const Film& film) {
  const Image picture = film.develop(Layer::Beauty);
  std::vector<double> means;
  double total = 0;
  for (int y0 = 0; y0 < kSide; y0 += kBlock) {
    for (int x0 = 0; x0 < kSide; x0 += kBlock) {
      double sum = 0;
      for (int y = y0; y < y0 + kBlock; ++y) {
        for (int x = x0; x < x0 + kBlock; ++x) sum += luminance(picture.color(x, y));
      }
      means.push_back(sum / (kBlock * kBlock));
      total += sum;
    }
  }
  means.push_back(total / (kSide * kSide));
  return means;
}

struct Method {
  std::string name;        // of the integrator
  std::string parameters;  // key=value,key=value
  uint32_t passes;
};

/// What independent runs of a method say about each block.
std::vector<Moments> measure(std::shared_ptr<const Scene> scene, const Method& method, int runs) {
  const IntegratorInfo& info = find_integrator(method.name);
  const auto settings = info.make_settings(scene->description().hints);
  for (size_t begin = 0; begin < method.parameters.size();) {
    const size_t equals = method.parameters.find('=', begin);
    const size_t end = std::min(method.parameters.find(',', equals), method.parameters.size());
    set_parameter(*settings, method.parameters.substr(begin, equals - begin),
                  method.parameters.substr(equals + 1, end - equals - 1));
    begin = end + 1;
  }
  std::vector<Moments> blocks(kSide / kBlock * (kSide / kBlock) + 1);
  Parallel parallel(2);
  const FilterSettings& filter = scene->camera().film().filter;
  for (int run = 0; run < runs; ++run) {
    Film film(kSide, kSide, filter);
    const auto integrator = info.create(scene, *settings);
    for (uint32_t pass = 0; pass < method.passes; ++pass) {
      integrator->render_pass(pass, film, {1000u + static_cast<uint64_t>(run), &parallel, {}});
    }
    EXPECT_EQ(film.rejected(), 0u);
    const std::vector<double> means = block_means(film);
    for (size_t i = 0; i < means.size(); ++i) blocks[i].add(means[i]);
  }
  return blocks;
}

/// Methods without bias, and those whose radius is so small that their bias is far below the noise.
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
      {"photon_map", "light_paths=30000,neighbors=20,gather_rays=50", 3},
      {"photon_map", "light_paths=30000,neighbors=20,gather_rays=4,irradiance_cache=false", 3},
  };
  if (scene.is_diffuse) {
    list.push_back({"light", "", 8});
    list.push_back({"bdpt", "light_paths=0.5,emission=false", 6});
  }
  return list;
}

/// Those with Markov chains, whose runs are less alike.
std::vector<Method> metropolis_methods() {
  return {{"mlt", "mutations=16", 6}, {"pssmlt", "mutations=16", 6}};
}

class Agreement : public ::testing::TestWithParam<ComparisonScene> {
 protected:
  /// `bias` is allowed for, relative to each mean.
  static void compare_with_path_tracer(const std::vector<Method>& tried, double bias = 0);
};

void Agreement::compare_with_path_tracer(const std::vector<Method>& tried, double bias) {
  const auto scene = testing::build(GetParam().make());
  const std::vector<Moments> expected = measure(scene, {"path", "", 32}, kRuns);
  const double level = statistics::sidak_level(
      kFalseAlarms, testing::comparison_scenes().size() * tried.size() * expected.size());
  for (const Method& method : tried) {
    const std::vector<Moments> found = measure(scene, method, kRuns);
    for (size_t i = 0; i < found.size(); ++i) {
      EXPECT_GT(statistics::welch_test(found[i], expected[i], bias * expected[i].mean()), level)
          << method.name << " " << method.parameters << ", block " << i << ": " << found[i].mean()
          << " +- " << found[i].standard_error() << " against " << expected[i].mean() << " +- "
          << expected[i].standard_error();
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
        "mutations=50000,light_paths=20000,importance_paths=50000,neighbors=30,gather_rays=40", 4}},
      0.01);
}

INSTANTIATE_TEST_SUITE_P(Scenes, MetropolisPhotonsAgreement,
                         ::testing::ValuesIn(testing::comparison_scenes(
                             {"cornell_box", "mirror_glass_box", "sun", "point_light",
                              "rough_dielectric", "normal_map"})),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace guidelight

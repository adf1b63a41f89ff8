// Guides change the noise of every method that follows them, not its result: independent runs with
// guides against independent runs without, by Welch's t-test of the means of quarters of the
// picture and of the whole. The seeds are fixed; false alarms of the whole file: 1e-3.

#include <gtest/gtest.h>

#include "renderer/transport/guide_mixture.h"
#include "tests/renderer/transport/guide_scenes.h"
#include "tests/statistics/hypothesis_tests.h"

namespace guidelight {
namespace {

using guide_test::LitScene;
using statistics::Moments;

constexpr int kSide = 32;
constexpr int kBlock = 16;
constexpr int kBlocks = 4;
constexpr int kRuns = 12;
constexpr double kFalseAlarms = 1e-3;

struct Method {
  std::string name;
  std::string parameters;  // key=value,key=value
  uint32_t passes = 8;
};

void PrintTo(const Method& method, std::ostream* out) { *out << method.name; }

/// With small radii, where the bias is the same with and without guides up to the noise; SPPM and
/// photon mapping adapt them to the photons found, so they are small there in particular.
const std::vector<Method>& methods() {
  static const std::vector<Method> list = {
      {"light", ""},
      {"bdpt", ""},
      {"vcm", "scene_radius=1,alpha=1"},
      {"vcm", "scene_radius=1,alpha=1,merge_direct=true,lean=true"},
      {"bpm", "scene_radius=1,alpha=1,light_paths=3"},
      {"bdpm", "scene_radius=2,neighbors=10,light_paths=3"},
      {"pppm", "scene_radius=1,alpha=1,light_paths=3"},
      {"sppm", "scene_radius=1,light_paths=4,alpha=1"},
      {"ppm", "scene_radius=1,light_paths=4,alpha=1"},
      // Wrong guides waste half of its photons, and its bias is that of the photons left.
      {"photon_map", "light_paths=60000,neighbors=20,gather_rays=20,global_distance=2", 3},
  };
  return list;
}

std::unique_ptr<IntegratorSettings> settings_of(const Method& method, const Scene& scene) {
  auto settings = find_integrator(method.name).make_settings(scene.description().hints);
  for (size_t begin = 0; begin < method.parameters.size();) {
    const size_t equals = method.parameters.find('=', begin);
    const size_t end = std::min(method.parameters.find(',', equals), method.parameters.size());
    set_parameter(*settings, method.parameters.substr(begin, equals - begin),
                  method.parameters.substr(equals + 1, end - equals - 1));
    begin = end + 1;
  }
  return settings;
}

/// Of quarters of the picture, and last of all of it. Guides may be others in every pass.
std::vector<Moments> measure(std::shared_ptr<const Scene> scene, const Method& method,
                             const std::vector<std::shared_ptr<const GuideMixture>>& guides) {
  std::vector<Moments> blocks(kBlocks + 1);
  const auto settings = settings_of(method, *scene);
  Parallel parallel(2);
  for (int run = 0; run < kRuns; ++run) {
    Film film(kSide, kSide, scene->camera().film().filter);
    const auto integrator = find_integrator(method.name).create(scene, *settings);
    PassContext context{.seed = 100u + static_cast<uint64_t>(run), .parallel = &parallel};
    for (uint32_t pass = 0; pass < method.passes; ++pass) {
      context.guides = guides[pass % guides.size()];
      integrator->render_pass(pass, film, context);
    }
    EXPECT_EQ(film.rejected(), 0u);
    const Image picture = film.develop(Layer::Beauty);
    double sums[kBlocks + 1] = {};
    for (int y = 0; y < kSide; ++y) {
      for (int x = 0; x < kSide; ++x) {
        const double value = luminance(picture.color(x, y));
        sums[y / kBlock * 2 + x / kBlock] += value / (kBlock * kBlock);
        sums[kBlocks] += value / (kSide * kSide);
      }
    }
    for (int i = 0; i <= kBlocks; ++i) blocks[i].add(sums[i]);
  }
  return blocks;
}

class GuidedAgreement : public ::testing::TestWithParam<Method> {};

TEST_P(GuidedAgreement, WithoutGuides) {
  constexpr size_t kLights = 3;
  const Method& method = GetParam();
  for (const size_t light : {size_t{1}, size_t{3}, size_t{8}}) {  // sphere, point, environment
    const LitScene& lit = guide_test::lit_scenes()[light];
    SceneDescription description = lit.describe(kSide);
    description.hints.max_depth = 5;
    const auto scene = testing::build(description);
    const auto useful = guide_test::guides_for(*scene, lit);
    GuidePath wrong = useful[1];
    wrong.vertices.resize(2);  // ends at the wall
    const auto mixture = [&](std::span<const GuidePath> guides) {
      return GuideMixture::build(scene, guides);
    };
    const auto hundred = guide_test::random_guides(*scene, lit, 100);
    const std::vector<std::pair<std::string, std::vector<std::shared_ptr<const GuideMixture>>>>
        tried = {{"useful", {mixture(useful)}},
                 {"wrong", {mixture({&wrong, 1})}},
                 {"hundred", {mixture(hundred)}},
                 {"changing", {mixture(useful), nullptr, mixture(hundred)}}};
    const std::vector<Moments> expected = measure(scene, method, {nullptr});
    const double level = statistics::sidak_level(
        kFalseAlarms, methods().size() * kLights * tried.size() * expected.size());
    for (const auto& [name, mixtures] : tried) {
      const std::vector<Moments> found = measure(scene, method, mixtures);
      for (size_t i = 0; i < found.size(); ++i) {
        EXPECT_GT(statistics::welch_test(found[i], expected[i]), level)
            << method.name << " " << lit.name << ", " << name << " guides, block " << i << ": "
            << found[i].mean() << " +- " << found[i].standard_error() << " against "
            << expected[i].mean() << " +- " << expected[i].standard_error();
      }
      // A test that compares noise with noise proves nothing.
      EXPECT_LT(found.back().standard_error(), 0.04 * found.back().mean())
          << method.name << " " << lit.name << ", " << name;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, GuidedAgreement, ::testing::ValuesIn(methods()),
                         [](const auto& test) {
                           return test.param.name + "_" + std::to_string(test.index);
                         });

}  // namespace
}  // namespace guidelight

// Guides change the noise of every method that follows them, not its result: independent runs with
// guides against independent runs without, by Welch's t-test of the means of quarters of the
// picture and of the whole. The seeds are fixed; false alarms of the whole file: 1e-3.

#include <gtest/gtest.h>

#include "renderer/transport/guide_mixture.h"
#include "tests/renderer/integrators/independent_runs.h"
#include "tests/renderer/transport/guide_scenes.h"

namespace guidelight {
namespace {

using guide_test::LitScene;
using statistics::Moments;
using testing::Method;

constexpr int kGuidedSide = 32;

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

/// Guides may be others in every pass.
std::vector<Moments> measure_guided(std::shared_ptr<const Scene> scene, const Method& method,
                                    std::vector<std::shared_ptr<const GuideMixture>> guides) {
  return testing::measure(
      std::move(scene), method,
      {.count = 12, .first_seed = 100, .block = kGuidedSide / 2, .guides = std::move(guides)});
}

class GuidedAgreement : public ::testing::TestWithParam<Method> {};

TEST_P(GuidedAgreement, WithoutGuides) {
  constexpr size_t kLights = 3;
  const Method& method = GetParam();
  for (const size_t light : {size_t{1}, size_t{3}, size_t{8}}) {  // sphere, point, environment
    const LitScene& lit = guide_test::lit_scenes()[light];
    SceneDescription description = lit.describe(kGuidedSide);
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
    const std::vector<Moments> expected = measure_guided(scene, method, {nullptr});
    const double level = statistics::sidak_level(
        statistics::kFalseAlarms, methods().size() * kLights * tried.size() * expected.size());
    for (const auto& [name, mixtures] : tried) {
      const std::vector<Moments> found = measure_guided(scene, method, mixtures);
      for (size_t i = 0; i < found.size(); ++i) {
        EXPECT_GT(statistics::welch_test(found[i], expected[i]), level)
            << method.name << " " << lit.name << ", " << name << " guides, block " << i << ": "
            << testing::describe(found[i], expected[i]);
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

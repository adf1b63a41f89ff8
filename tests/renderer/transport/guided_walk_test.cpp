// Light paths that follow guides leave photons of the same power where paths without guides do, on
// every kind of light. False alarms: 1e-3 for each test, over all lights.

#include <gtest/gtest.h>

#include "renderer/photons/photon_tracer.h"
#include "tests/renderer/transport/guide_scenes.h"
#include "tests/statistics/hypothesis_tests.h"

namespace guidelight {
namespace {

using guide_test::LitScene;
using statistics::Moments;

constexpr int kWalkRuns = 24;
constexpr size_t kWalkPaths = 8000;
constexpr int kWalkLengths = 4;
constexpr int kWalkCells = 4;

/// Power by place on the floor and number of segments, of independent runs.
std::vector<Moments> powers(const Scene& scene, const std::optional<GuidedEmission>& guided) {
  std::vector<Moments> result(kWalkLengths * kWalkCells * kWalkCells);
  Parallel parallel(2);
  PhotonTracer tracer;
  for (int run = 0; run < kWalkRuns; ++run) {
    std::vector<double> sums(result.size());
    const LightPathRange range{77, static_cast<uint64_t>(run), kWalkPaths, kWalkLengths, guided};
    for (const Photon& photon : tracer.trace(scene, range, parallel)) {
      const Vec3 p = photon.position;
      if (p.y > -0.999f) continue;
      const auto along = [](float x) {
        return std::clamp(static_cast<int>((x + 1) * kWalkCells / 2), 0, kWalkCells - 1);
      };
      const int length = std::min(photon.length(), kWalkLengths) - 1;
      sums[(length * kWalkCells + along(p.x)) * kWalkCells + along(p.z)] +=
          luminance(photon.power());
    }
    for (size_t i = 0; i < sums.size(); ++i) result[i].add(sums[i] / kWalkPaths);
  }
  return result;
}

struct Tried {
  const char* name;
  std::vector<GuidePath> guides;
};

/// Useful ones; one that leads away from everything but the wall; a hundred.
std::vector<Tried> tried_guides(const Scene& scene, const LitScene& lit) {
  const std::vector<GuidePath> useful = guide_test::guides_for(scene, lit);
  std::vector<Tried> list = {{"useful", useful},
                             {"hundred", guide_test::random_guides(scene, lit, 100)}};
  GuidePath wrong = useful[1];
  wrong.vertices.resize(2);  // ends at the wall
  for (GuideVertex& vertex : wrong.vertices) vertex.cone = 0.01f;
  list.push_back({"wrong", {wrong}});
  return list;
}

class GuidedWalkAgreement : public ::testing::TestWithParam<LitScene> {};

TEST_P(GuidedWalkAgreement, PhotonsHaveTheSamePower) {
  const auto scene = GetParam().build();
  const std::vector<Moments> expected = powers(*scene, std::nullopt);
  const std::vector<Tried> tried = tried_guides(*scene, GetParam());
  const double level = statistics::sidak_level(
      statistics::kFalseAlarms, guide_test::lit_scenes().size() * tried.size() * expected.size());
  for (const Tried& guides : tried) {
    const auto mixture = GuideMixture::build(scene, guides.guides);
    ASSERT_EQ(mixture->size(), guides.guides.size());
    const std::vector<Moments> found = powers(*scene, GuidedEmission{mixture.get(), 0.6f});
    int compared = 0;
    for (size_t i = 0; i < found.size(); ++i) {
      // Where almost no photons fall, sums are not normally distributed.
      if (!(expected[i].standard_error() < 0.08 * expected[i].mean())) continue;
      ++compared;
      EXPECT_GT(statistics::welch_test(found[i], expected[i]), level)
          << guides.name << ", cell " << i << ": " << found[i].mean() << " +- "
          << found[i].standard_error() << " for " << expected[i].mean() << " +- "
          << expected[i].standard_error();
    }
    EXPECT_GT(compared, 15) << guides.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Lights, GuidedWalkAgreement, ::testing::ValuesIn(guide_test::lit_scenes()),
                         guide_test::kSceneName);

TEST(GuidedWalk, CausticNeedsFewerPaths) {
  const LitScene& lit = guide_test::lit_scenes()[1];
  const auto scene = lit.build();
  GuidePath guide = guide_test::guides_for(*scene, lit)[2];
  guide.disc_radius = 0.15f;
  const auto mixture = GuideMixture::build(scene, std::vector<GuidePath>{guide});
  Parallel parallel(2);
  PhotonTracer tracer;
  const auto caustic_photons = [&](const std::optional<GuidedEmission>& guided) {
    const auto& photons = tracer.trace(*scene, {1, 0, kWalkPaths, 4, guided}, parallel);
    return std::ranges::count_if(photons, [](const Photon& photon) { return photon.caustic(); });
  };
  EXPECT_GT(caustic_photons(GuidedEmission{mixture.get(), 0.5f}),
            4 * caustic_photons(std::nullopt));
}

}  // namespace
}  // namespace guidelight

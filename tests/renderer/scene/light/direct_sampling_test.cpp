// sample_direct and its densities, for every kind of light.

#include <gtest/gtest.h>

#include "tests/renderer/scene/light/light_cases.h"
#include "tests/renderer/scene/light/light_statistics.h"

namespace guidelight {
namespace {

using namespace light_test;

class DirectSampling : public ::testing::TestWithParam<Case> {
 protected:
  Lamp lamp_ = GetParam().make();

  /// Density and radiance that a path which is scattered from `reference` towards w finds.
  std::pair<float, Color> found(Vec3 reference, Vec3 w) const {
    if (lamp_.light->is_infinite()) {
      return {lamp_.light->pdf_direct_from(w), lamp_.light->radiance_from(w)};
    }
    SurfacePoint point;
    if (!lamp_.intersect({reference, w, kInfinity}, point)) return {0, Color(0)};
    return {lamp_.light->pdf_direct(reference, point), lamp_.light->radiance(point, -w)};
  }
};

class DistantDirectSampling : public DirectSampling {};

const Vec3 kReferences[] = {Vec3(0), Vec3(0.8f, -1, 1.5f), Vec3(0.1f, 0.5f, -1.5f)};

TEST_P(DirectSampling, EveryPartOfTheLightIsFoundAsOftenAsPdfSays) {
  for (const Vec3 reference : kReferences) {
    if (lamp_.light->is_infinite() && reference != Vec3(0)) continue;  // nothing depends on it
    expect_solid_angles(
        [&](Rng& rng) {
          const auto sample = lamp_.light->sample_direct(reference, rng.next_vec2());
          const bool lit = sample && !is_black(sample->radiance);
          return lit ? DrawnDirection{sample->wi, sample->pdf} : DrawnDirection{};
        },
        [&](Vec3 w) {
          const auto [pdf, radiance] = found(reference, w);
          return pdf > 0 && !is_black(radiance) ? 1 : 0;
        },
        non_delta_lights().size() * std::size(kReferences));
  }
}

/// Where the density is bounded, counts can be compared.
TEST_P(DistantDirectSampling, DirectionsAreDistributedAsPdfSays) {
  expect_distribution(
      [&](Rng& rng) {
        const auto sample = lamp_.light->sample_direct(Vec3(0), rng.next_vec2());
        EXPECT_TRUE(sample);
        return sample ? sample->wi : Vec3(0, 0, 1);
      },
      [&](Vec3 w) { return lamp_.light->pdf_direct_from(w); }, 1,
      statistics::sidak_level(kFamilyLevel, distant_lights().size()));
}

TEST_P(DirectSampling, SamplesSayWhatRaysFind) {
  Rng rng(2, 0, 0);
  int compared = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec3 reference = kReferences[i % std::size(kReferences)];
    const auto sample = lamp_.light->sample_direct(reference, rng.next_vec2());
    if (!sample) continue;
    ASSERT_NEAR(glm::length(sample->wi), 1, 1e-5f);
    const EmissionPdf emission = lamp_.light->pdf_emission(sample->point, -sample->wi);
    ASSERT_NEAR(emission.position / sample->pdf_position, 1, 1e-3f);
    if (!lamp_.light->is_infinite()) {
      ASSERT_NEAR(glm::length(reference + sample->distance * sample->wi - sample->position), 0,
                  1e-4f);
      if (sample->cos_light < 0.02f) continue;  // too oblique to compare numbers
      ASSERT_NEAR(sample->cos_light, -glm::dot(sample->wi, sample->point.geometric_normal), 1e-4f);
    }
    ASSERT_NEAR(emission.direction / sample->pdf_direction, 1, 1e-2f);
    const auto [pdf, radiance] = found(reference, sample->wi);
    if (pdf == 0 && ++compared)
      continue;  // by rounding, at an edge; counted against the test below
    ASSERT_NEAR(pdf / sample->pdf, 1, 2e-2f);
    ASSERT_NEAR(glm::length(radiance - sample->radiance), 0,
                0.02f * (1e-3f + glm::length(radiance)));
    compared += 1000;
  }
  EXPECT_GT(compared / 1000, 200 * (compared % 1000));
  EXPECT_GT(compared / 1000, 5000);
}

INSTANTIATE_TEST_SUITE_P(All, DirectSampling, ::testing::ValuesIn(non_delta_lights()), kCaseName);
INSTANTIATE_TEST_SUITE_P(All, DistantDirectSampling, ::testing::ValuesIn(distant_lights()),
                         kCaseName);

}  // namespace
}  // namespace guidelight

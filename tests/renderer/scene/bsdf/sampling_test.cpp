#include <gtest/gtest.h>

#include "renderer/sampling/random.h"
#include "renderer/scene/bsdf/scattering.h"
#include "tests/renderer/scene/bsdf/bsdf_cases.h"
#include "tests/statistics/hypothesis_tests.h"
#include "tests/statistics/sphere_histogram.h"

/// sample() against pdf() and eval(), seen through Scattering, for every BSDF, both transport
/// modes, several incident directions and a shading normal that is not the geometric one.
namespace guidelight::bsdf_test {
namespace {

constexpr int kBsdfSamples = 50000;

const Vec3 kIncident[] = {direction(0.5f, 10), direction(40, 100), direction(75, 230),
                          direction(88, 300),  direction(130, 45), direction(170, 200)};

/// Shading frame rotated against the axes, geometric normal tilted by 15° against it.
SurfacePoint shading_point(const Bsdf& bsdf) {
  SurfacePoint point = flat_point(bsdf);
  point.frame = Frame::from_normal_and_tangent(direction(50, 70), Vec3(1, 0, 0));
  point.geometric_normal = point.frame.to_world(direction(15, 120));
  return point;
}

/// Outcomes of sampling: the cells of the sphere, then these.
enum Outcome { kReflected, kTransmitted, kOutcomeCount };

class BsdfSampling : public ::testing::TestWithParam<Case> {
 protected:
  std::shared_ptr<const Bsdf> bsdf_ = GetParam().build();
};

/// The discrete probability of a delta lobe, none if it leaks.
double delta_probability(const SurfacePoint& point, Vec3 wo_local, Lobe lobe) {
  const auto event = point.bsdf->specular(point, wo_local, lobe);
  if (!event) return 0;
  const auto sides_agree = [&](Vec3 local) {
    return glm::dot(point.frame.to_world(local), point.geometric_normal) * local.z > 0;
  };
  const bool is_straight = event->wi == -wo_local;
  return is_straight || (sides_agree(event->wi) && sides_agree(wo_local)) ? event->probability : 0;
}

double chi_square(const SurfacePoint& point, Vec3 wo_local, TransportMode mode, uint64_t seed) {
  const statistics::SphereGrid grid;
  const Scattering scattering(point, point.frame.to_world(wo_local), mode);

  std::vector<double> observed(grid.size() + kOutcomeCount);
  double drawn_count = 0;
  Rng rng(seed, 0, 0);
  for (int i = 0; i < kBsdfSamples; ++i) {
    const float u_lobe = rng.next_float();
    const auto drawn = scattering.sample(u_lobe, rng.next_vec2());
    if (!drawn) continue;
    ++drawn_count;
    if (drawn->is_delta()) {
      ++observed[grid.size() + (drawn->lobe == kLobeDeltaReflection ? kReflected : kTransmitted)];
    } else {
      ++observed[grid.cell(point.frame.to_local(drawn->wi))];
    }
  }

  std::vector<double> expected = grid.integrate(
      [&](Vec3 wi_local) { return scattering.pdf(point.frame.to_world(wi_local)); }, 1e-5);
  double total = 0;
  for (const double e : expected) total += e;
  expected.push_back(delta_probability(point, wo_local, kLobeDeltaReflection));
  expected.push_back(delta_probability(point, wo_local, kLobeDeltaTransmission));
  total += expected[grid.size()] + expected[grid.size() + 1];

  // What is drawn at all, within 5 standard deviations and the quadrature's error …
  const double drawn_share = drawn_count / kBsdfSamples;
  EXPECT_NEAR(drawn_share, total,
              1e-3 + 5 * std::sqrt(drawn_share * (1 - drawn_share) / kBsdfSamples));
  // … and where it goes.
  for (double& e : expected) e *= drawn_count / total;
  if (drawn_count == 0) return 1;
  return statistics::chi_square_test(observed, expected).p_value;
}

TEST_P(BsdfSampling, DirectionsAndLobesAreDistributedAsPdfSays) {
  const size_t tests = all_cases().size() * std::size(kIncident) * 2;
  const double level = statistics::sidak_level(statistics::kFalseAlarms, tests);
  const SurfacePoint flat = flat_point(*bsdf_);
  const SurfacePoint tilted = shading_point(*bsdf_);
  uint64_t seed = 0;
  for (const Vec3 wo : kIncident) {
    EXPECT_GT(chi_square(flat, wo, TransportMode::Radiance, ++seed), level)
        << "flat, wo.z = " << wo.z;
    EXPECT_GT(chi_square(tilted, wo, TransportMode::Importance, ++seed), level)
        << "tilted, wo.z = " << wo.z;
  }
}

TEST_P(BsdfSampling, WeightIsValueOverPdf) {
  for (const TransportMode mode : {TransportMode::Radiance, TransportMode::Importance}) {
    const SurfacePoint point = shading_point(*bsdf_);
    for (const Vec3 wo_local : kIncident) {
      const Vec3 wo = point.frame.to_world(wo_local);
      const Scattering scattering(point, wo, mode);
      Rng rng(7, 0, 0);
      for (int i = 0; i < 2000; ++i) {
        const float u_lobe = rng.next_float();
        const auto drawn = scattering.sample(u_lobe, rng.next_vec2());
        if (!drawn) continue;
        ASSERT_NEAR(glm::length(drawn->wi), 1, 1e-4f);
        ASSERT_GT(drawn->pdf, 0);
        ASSERT_GE(min_component(drawn->weight), 0);
        ASSERT_TRUE(is_finite(drawn->weight));
        if (drawn->is_delta()) continue;
        const float pdf = scattering.pdf(drawn->wi);
        const Vec3 value = scattering.value(drawn->wi);
        const float scale = std::max(max_component(value), 1e-3f * pdf);
        ASSERT_NEAR(drawn->pdf / pdf, 1, 0.02f) << "wo.z = " << wo_local.z;
        ASSERT_LT(max_component(glm::abs(drawn->weight * drawn->pdf - value)), 0.02f * scale)
            << "wo.z = " << wo_local.z;
        const Scattering reversed(point, drawn->wi, mode);
        ASSERT_NEAR(scattering.pdf_reverse(drawn->wi), reversed.pdf(wo), 0.02f * reversed.pdf(wo));
      }
    }
  }
}

TEST_P(BsdfSampling, DeltaSamplesAreTheSpecularEvents) {
  const SurfacePoint point = flat_point(*bsdf_);
  for (const Vec3 wo : kIncident) {
    Rng rng(8, 0, 0);
    for (int i = 0; i < 200; ++i) {
      const float u_lobe = rng.next_float();
      const auto drawn = bsdf_->sample(point, wo, u_lobe, rng.next_vec2());
      if (!drawn || !drawn->is_delta()) continue;
      const auto event = bsdf_->specular(point, wo, drawn->lobe);
      ASSERT_TRUE(event);
      // Where two transmissions differ, specular() knows only one of them.
      if (glm::length(event->wi - drawn->wi) > 1e-4f) continue;
      EXPECT_NEAR(event->probability, drawn->pdf, 1e-5f);
      EXPECT_EQ(event->eta, drawn->eta);
      EXPECT_LT(glm::length(event->value - drawn->weight * drawn->pdf), 1e-5f);
    }
  }
}

TEST_P(BsdfSampling, LobesAreAnnounced) {
  const SurfacePoint point = flat_point(*bsdf_);
  Rng rng(9, 0, 0);
  for (const Vec3 wo : kIncident) {
    for (int i = 0; i < 200; ++i) {
      const float u_lobe = rng.next_float();
      const auto drawn = bsdf_->sample(point, wo, u_lobe, rng.next_vec2());
      EXPECT_TRUE(!drawn || bsdf_->lobes() & drawn->lobe);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(EveryBsdf, BsdfSampling, ::testing::ValuesIn(all_cases()),
                         [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace guidelight::bsdf_test

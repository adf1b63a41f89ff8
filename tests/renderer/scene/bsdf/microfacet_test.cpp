#include "renderer/scene/bsdf/microfacet.h"

#include <gtest/gtest.h>

#include "renderer/sampling/random.h"
#include "renderer/scene/bsdf/fresnel.h"
#include "renderer/scene/bsdf/rough_interface.h"
#include "tests/renderer/scene/bsdf/bsdf_cases.h"
#include "tests/statistics/hypothesis_tests.h"
#include "tests/statistics/sphere_histogram.h"

namespace guidelight::bsdf_test {
namespace {

using statistics::SphereGrid;

struct Facets {
  std::string name;
  Microfacet kind;
  float alpha_u;
  float alpha_v;

  MicrofacetDistribution build() const { return {kind, alpha_u, alpha_v}; }
};

class MicrofacetTest : public ::testing::TestWithParam<Facets> {};

double total(const std::vector<double>& integrals) {
  double sum = 0;
  for (const double i : integrals) sum += i;
  return sum;
}

TEST_P(MicrofacetTest, FacetsProjectToTheMacrosurface) {
  // ∫ D(m) (m·n) dm = 1 (Walter et al. 2007, eq. 4).
  const MicrofacetDistribution facets = GetParam().build();
  const auto integrals =
      SphereGrid(100, 20).integrate([&](Vec3 m) { return facets.density(m) * m.z; });
  EXPECT_NEAR(total(integrals), 1, 1e-3);
}

TEST_P(MicrofacetTest, VisibleFacetsProjectToTheMacrosurfaceFromEverywhere) {
  // ∫ G₁(w, m) D(m) max(0, w·m) dm = w·n: what makes pdf_visible a density (Heitz 2014, eq. 14).
  const MicrofacetDistribution facets = GetParam().build();
  for (const Vec3 w :
       {direction(1, 0), direction(45, 30), direction(80, 100), direction(88, 200)}) {
    EXPECT_NEAR(
        total(SphereGrid(100, 20).integrate([&](Vec3 m) { return facets.pdf_visible(w, m); })), 1,
        2e-3);
  }
}

TEST_P(MicrofacetTest, VisibleNormalsAreDrawnAsTheirDensitySays) {
  constexpr int kSamples = 50000;
  const MicrofacetDistribution facets = GetParam().build();
  const SphereGrid grid(60, 20);
  for (const Vec3 w : {direction(0, 0), direction(45, 30), direction(85, 200)}) {
    std::vector<double> observed(grid.size());
    Rng rng(31, 0, 0);
    for (int i = 0; i < kSamples; ++i) {
      const Vec3 m = facets.sample_visible(w, rng.next_vec2());
      ASSERT_GT(glm::dot(w, m), -1e-6f);
      ++observed[grid.cell(m)];
    }
    auto expected = grid.integrate([&](Vec3 m) { return facets.pdf_visible(w, m); }, 1e-5);
    for (double& e : expected) e *= kSamples;
    // 18 tests, false alarm rate 1e-3 together.
    EXPECT_GT(statistics::chi_square_test(observed, expected).p_value,
              statistics::sidak_level(1e-3, 18));
  }
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, MicrofacetTest,
    ::testing::Values(Facets{"smooth_ggx", Microfacet::Ggx, 0.1f, 0.1f},
                      Facets{"rough_ggx", Microfacet::Ggx, 0.7f, 0.7f},
                      Facets{"brushed_ggx", Microfacet::Ggx, 0.15f, 0.6f},
                      Facets{"smooth_beckmann", Microfacet::Beckmann, 0.1f, 0.1f},
                      Facets{"rough_beckmann", Microfacet::Beckmann, 0.7f, 0.7f},
                      Facets{"brushed_beckmann", Microfacet::Beckmann, 0.5f, 0.15f}),
    [](const auto& test) { return test.param.name; });

TEST(Fresnel, DielectricAtTheAnglesThatHaveClosedForms) {
  EXPECT_NEAR(fresnel_dielectric(1, 1.5f).reflectance, 0.04f, 1e-6f);   // ((η-1)/(η+1))²
  EXPECT_NEAR(fresnel_dielectric(-1, 1.5f).reflectance, 0.04f, 1e-6f);  // the same from inside
  EXPECT_EQ(fresnel_dielectric(1e-7f, 1.5f).reflectance > 0.999f, true);
  // Brewster's angle, tan θ = η: p is not reflected, s by ((η²-1)/(η²+1))².
  const float brewster = 1 / std::sqrt(1 + 2.25f);
  EXPECT_NEAR(fresnel_dielectric(brewster, 1.5f).reflectance, 0.5f * sqr(1.25f / 3.25f), 1e-6f);
  // Beyond the critical angle, sin θ = 1/η.
  EXPECT_EQ(fresnel_dielectric(-0.7f, 1.5f).reflectance, 1);
  EXPECT_LT(fresnel_dielectric(-0.75f, 1.5f).reflectance, 1);
}

TEST(Fresnel, ConductorWithoutAbsorptionIsADielectric) {
  for (const float cos_theta : {0.05f, 0.3f, 0.7f, 1.0f}) {
    EXPECT_NEAR(fresnel_conductor(cos_theta, Color(1.5f), Color(0.0f)).x,
                fresnel_dielectric(cos_theta, 1.5f).reflectance, 1e-5f);
  }
  // At normal incidence ((η-1)² + k²)/((η+1)² + k²).
  EXPECT_NEAR(fresnel_conductor(1, Color(0.2f), Color(3.9f)).x, (0.64f + 15.21f) / (1.44f + 15.21f),
              1e-5f);
  EXPECT_NEAR(fresnel_conductor(0.4f, Color(0.0f), Color(1.0f)).x, 1, 1e-6f);
}

TEST(Fresnel, DiffuseReflectanceAgreesWithTheTable) {
  // Egan & Hilgeman 1973 and Walsh's closed form give 0.0918 for η = 1.5; reciprocity gives the
  // inside: 1 - R(1/η) = (1 - R(η))/η².
  const float outside = diffuse_fresnel_reflectance(1.5f);
  EXPECT_NEAR(outside, 0.0918f, 1e-4f);
  EXPECT_NEAR(1 - diffuse_fresnel_reflectance(1 / 1.5f), (1 - outside) / 2.25f, 1e-4f);
}

TEST(Fresnel, RefractionObeysSnell) {
  for (const Vec3 w : {direction(30, 20), direction(70, 200), direction(150, 40)}) {
    const DielectricFresnel fresnel = fresnel_dielectric(w.z, 1.5f);
    const Vec3 t = refract(w, fresnel);
    EXPECT_NEAR(glm::length(t), 1, 1e-6f);
    EXPECT_LT(t.z * w.z, 0);
    EXPECT_NEAR(std::sqrt(sin2_theta(w)), fresnel.eta * std::sqrt(sin2_theta(t)), 1e-6f);
    EXPECT_LT(glm::length(refract(w, Vec3(0, 0, 1), fresnel) - t), 1e-6f);
  }
}

TEST(RoughInterface, BecomesFresnelAsRoughnessVanishes) {
  const RoughInterface table(Microfacet::Ggx, 1.5f, 1e-3f, 1e-3f);
  for (const float cos_theta : {0.3f, 0.6f, 1.0f}) {
    EXPECT_NEAR(table.transmittance(cos_theta, 1e-3f),
                1 - fresnel_dielectric(cos_theta, 1.5f).reflectance, 2e-3f);
  }
  EXPECT_NEAR(diffuse_rough_reflectance(Microfacet::Ggx, 1.5f, 1e-3f),
              diffuse_fresnel_reflectance(1.5f), 2e-3f);
}

TEST(RoughInterface, TransmittanceIsThatOfTheRoughDielectric) {
  // Monte Carlo with the BSDF itself; one row, and interpolated between the rows of a textured
  // roughness.
  constexpr float kAlpha = 0.3f;
  const auto bsdf = build(DielectricBsdf{.int_ior = 1.5f,
                                         .ext_ior = 1,
                                         .alpha_u = {kAlpha},
                                         .alpha_v = {kAlpha},
                                         .distribution = Microfacet::Ggx});
  const SurfacePoint point = flat_point(*bsdf);
  const RoughInterface single(Microfacet::Ggx, 1.5f, kAlpha, kAlpha);
  const RoughInterface range(Microfacet::Ggx, 1.5f, kMinAlpha, 1.0f);
  for (const float theta : {5.0f, 50.0f, 75.0f}) {
    Rng rng(32, 0, 0);
    statistics::Moments transmitted;
    for (int i = 0; i < 20000; ++i) {
      const float u_lobe = rng.next_float();
      const auto drawn = bsdf->sample(point, direction(theta, 0), u_lobe, rng.next_vec2());
      transmitted.add(drawn && drawn->wi.z < 0 ? drawn->weight.x : 0.0);
    }
    const float cos_theta = direction(theta, 0).z;
    EXPECT_GT(statistics::t_test(transmitted, single.transmittance(cos_theta, kAlpha), 1e-3), 1e-4);
    EXPECT_GT(statistics::t_test(transmitted, range.transmittance(cos_theta, kAlpha), 3e-3), 1e-4);
  }
}

}  // namespace
}  // namespace guidelight::bsdf_test

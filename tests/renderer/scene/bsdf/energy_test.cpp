#include <gtest/gtest.h>

#include "renderer/sampling/random.h"
#include "tests/renderer/scene/bsdf/bsdf_cases.h"
#include "tests/statistics/hypothesis_tests.h"

/// Directional albedo: the mean of f·cos/pdf over samples is the share of light that leaves the
/// surface.
namespace guidelight::bsdf_test {
namespace {

using statistics::Moments;
using statistics::t_test;

constexpr int kEnergySamples = 20000;
constexpr double kEnergyLevel = 1e-5;  // per test of about a hundred: false alarms 1e-3 together

const float kAngles[] = {1, 30, 60, 80, 88, 110, 135, 150, 179};

Moments sampled_albedo(const Bsdf& bsdf, Vec3 wo) {
  const SurfacePoint point = flat_point(bsdf);
  Rng rng(11, 0, 0);
  Moments moments;
  for (int i = 0; i < kEnergySamples; ++i) {
    const float u_lobe = rng.next_float();
    const auto drawn = bsdf.sample(point, wo, u_lobe, rng.next_vec2());
    moments.add(drawn ? max_component(drawn->weight) : 0.0);
  }
  return moments;
}

class BsdfEnergy : public ::testing::TestWithParam<Case> {};

TEST_P(BsdfEnergy, NoMoreLightLeavesThanArrives) {
  const auto bsdf = GetParam().build();
  for (const float theta : kAngles) {
    const Moments albedo = sampled_albedo(*bsdf, direction(theta, 77));
    EXPECT_LT(albedo.mean(), 1 + 4.5 * albedo.standard_error() + 1e-4) << theta << "°";
  }
}

TEST_P(BsdfEnergy, AlbedoIsAShare) {
  const auto bsdf = GetParam().build();
  const Color albedo = bsdf->albedo(flat_point(*bsdf));
  EXPECT_GE(min_component(albedo), 0);
  EXPECT_LE(max_component(albedo), 1.0f);
}

INSTANTIATE_TEST_SUITE_P(EveryBsdf, BsdfEnergy, ::testing::ValuesIn(all_cases()),
                         [](const auto& test) { return test.param.name; });

TEST(WhiteFurnace, LosslessSurfacesReturnEverything) {
  const std::vector<std::shared_ptr<const Bsdf>> front = {
      build(DiffuseBsdf{.reflectance = {Color(1.0f)}}),
      build(ConductorBsdf{}),
      build(DielectricBsdf{}),
      build(ThinDielectricBsdf{}),
      build(NullBsdf{}),
      build(DielectricBsdf{}, MaskBsdf{.opacity = {0.3f}, .nested = 0}),
      build(DielectricBsdf{}, ConductorBsdf{}, BlendBsdf{.first = 0, .second = 1})};
  for (const auto& bsdf : front) {
    for (const float theta : {1.0f, 30.0f, 60.0f, 85.0f}) {
      const Moments albedo = sampled_albedo(*bsdf, direction(theta, 10));
      EXPECT_GT(t_test(albedo, 1, 1e-5), kEnergyLevel);
    }
  }
  for (const float theta : {100.0f, 125.0f, 140.0f, 179.0f}) {
    EXPECT_GT(t_test(sampled_albedo(*build(DielectricBsdf{}), direction(theta, 10)), 1, 1e-5),
              kEnergyLevel);
  }
}

TEST(WhiteFurnace, RoughInterfacesLoseOnlyWhatScattersTwice) {
  // Single-scattering microfacets lose little at low roughness, more at high.
  for (const Microfacet kind : {Microfacet::Ggx, Microfacet::Beckmann}) {
    const auto albedo = [kind](float alpha) {
      const auto bsdf =
          build(DielectricBsdf{.alpha_u = {alpha}, .alpha_v = {alpha}, .distribution = kind});
      return sampled_albedo(*bsdf, direction(30, 0)).mean();
    };
    EXPECT_NEAR(albedo(0.01f), 1, 1e-3);
    EXPECT_GT(albedo(0.1f), 0.99);
    EXPECT_GT(albedo(0.5f), 0.9);
    EXPECT_LT(albedo(0.5f), 0.995);
  }
}

TEST(WhiteFurnace, PlasticWithAWhiteBaseReturnsEverything) {
  // What enters the coat leaves it at last, after any number of internal reflections: the series of
  // the base sums to 1 over the hemisphere up to the assumption that the light inside is diffuse,
  // which holds for diffuse illumination; so the albedo for diffuse light is 1.
  const auto bsdf = build(PlasticBsdf{.diffuse_reflectance = {Color(1.0f)}});
  Rng rng(12, 0, 0);
  Moments moments;
  const SurfacePoint point = flat_point(*bsdf);
  for (int i = 0; i < 200000; ++i) {
    const float cos_theta = std::sqrt(rng.next_float());  // cosine-weighted
    const Vec3 wo(safe_sqrt(1 - cos_theta * cos_theta), 0, cos_theta);
    const float u_lobe = rng.next_float();
    const auto drawn = bsdf->sample(point, wo, u_lobe, rng.next_vec2());
    moments.add(drawn ? drawn->weight.x : 0.0);
  }
  EXPECT_GT(t_test(moments, 1, 1e-3), kEnergyLevel);
}

TEST(DeltaLobes, AreChosenAsOftenAsTheyReflect) {
  // At normal incidence glass of IOR 1.5 reflects 4 %, a pane 2·0.04/1.04.
  const DielectricBsdf glass{.int_ior = 1.5f, .ext_ior = 1};
  const auto count = [](const Bsdf& bsdf) {
    const SurfacePoint point = flat_point(bsdf);
    Rng rng(13, 0, 0);
    Moments reflections;
    for (int i = 0; i < 100000; ++i) {
      const float u_lobe = rng.next_float();
      const auto drawn = bsdf.sample(point, Vec3(0, 0, 1), u_lobe, rng.next_vec2());
      reflections.add(drawn->lobe == kLobeDeltaReflection);
    }
    return reflections;
  };
  EXPECT_GT(t_test(count(*build(glass)), 0.04), kEnergyLevel);
  EXPECT_GT(t_test(count(*build(ThinDielectricBsdf{.int_ior = 1.5f, .ext_ior = 1})), 0.08 / 1.04),
            kEnergyLevel);
  EXPECT_GT(t_test(count(*build(glass, MaskBsdf{.opacity = {0.5f}, .nested = 0})), 0.02),
            kEnergyLevel);
}

}  // namespace
}  // namespace guidelight::bsdf_test

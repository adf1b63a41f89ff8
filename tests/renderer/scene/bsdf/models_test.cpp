#include <gtest/gtest.h>

#include "renderer/error.h"
#include "renderer/scene/bsdf/fresnel.h"
#include "renderer/scene/bsdf/microfacet.h"
#include "tests/renderer/scene/bsdf/bsdf_cases.h"

/// Values of single models against their formulas, and what make_bsdfs makes of odd descriptions.
namespace guidelight::bsdf_test {
namespace {

Color eval(const Bsdf& bsdf, Vec3 wo, Vec3 wi) { return bsdf.eval(flat_point(bsdf), wo, wi); }

const Vec3 kUp(0, 0, 1);

TEST(Diffuse, IsReflectanceOverPi) {
  const auto bsdf = build(DiffuseBsdf{.reflectance = {Color(0.5f)}});
  EXPECT_FLOAT_EQ(eval(*bsdf, kUp, direction(60, 0)).x, 0.5f * 0.5f * kInvPi);
  EXPECT_EQ(eval(*bsdf, kUp, direction(120, 0)).x, 0);
  EXPECT_EQ(eval(*bsdf, -kUp, kUp).x, 0);
}

TEST(RoughDiffuse, WithoutRoughnessIsDiffuseAndOtherwiseBackscatters) {
  const auto smooth = build(RoughDiffuseBsdf{.alpha = {0.0f}});
  EXPECT_FLOAT_EQ(eval(*smooth, direction(40, 0), direction(60, 90)).x, 0.5f * 0.5f * kInvPi);
  const auto rough = build(RoughDiffuseBsdf{.alpha = {0.6f}});
  EXPECT_GT(eval(*rough, direction(60, 0), direction(60, 0)).x,
            1.5f * eval(*rough, direction(60, 0), direction(60, 180)).x);
}

TEST(Conductor, SmoothIsTheLimitOfRough) {
  const Color eta(0.2f, 0.9f, 1.4f);
  const Color k(3.9f, 2.4f, 1.8f);
  const auto smooth = build(ConductorBsdf{.eta = eta, .k = k});
  const auto rough =
      build(ConductorBsdf{.eta = eta, .k = k, .alpha_u = {0.002f}, .alpha_v = {0.002f}});
  const Vec3 wo = direction(50, 20);
  const auto mirror = smooth->specular(flat_point(*smooth), wo, kLobeDeltaReflection);
  const auto glossy = rough->sample(flat_point(*rough), wo, 0.5f, Vec2(0.3f, 0.6f));
  EXPECT_LT(glm::length(mirror->value - glossy->weight), 1e-2f);
  EXPECT_LT(glm::length(mirror->wi - glossy->wi), 1e-2f);
  EXPECT_EQ(smooth->lobes(), kLobeDeltaReflection);
  EXPECT_EQ(rough->lobes(), kLobeGlossy);
}

TEST(Dielectric, RoughnessBelowTheLimitIsSmooth) {
  const auto lobes = [](float alpha, float int_ior) {
    return build(DielectricBsdf{
                     .int_ior = int_ior, .ext_ior = 1, .alpha_u = {alpha}, .alpha_v = {alpha}})
        ->lobes();
  };
  EXPECT_EQ(lobes(0.5f * kMinAlpha, 1.5f), kLobeDelta);
  EXPECT_EQ(lobes(2 * kMinAlpha, 1.5f), kLobeGlossy);
  EXPECT_EQ(lobes(0.5f, 1.0f), kLobeDelta);  // nothing to scatter
}

TEST(Dielectric, ColoursScaleTheirOwnLobe) {
  const auto bsdf = build(DielectricBsdf{.int_ior = 1.5f,
                                         .ext_ior = 1,
                                         .specular_reflectance = {Color(0.5f)},
                                         .specular_transmittance = {Color(0.25f)}});
  const SurfacePoint point = flat_point(*bsdf);
  EXPECT_NEAR(bsdf->specular(point, kUp, kLobeDeltaReflection)->value.x, 0.5f * 0.04f, 1e-6f);
  EXPECT_NEAR(bsdf->specular(point, kUp, kLobeDeltaTransmission)->value.x, 0.25f * 0.96f, 1e-6f);
}

TEST(Plastic, IsMitsubasFormula) {
  const auto bsdf = build(PlasticBsdf{
      .int_ior = 1.5f, .ext_ior = 1, .diffuse_reflectance = {Color(0.5f)}, .nonlinear = false});
  const Vec3 wo = direction(20, 0);
  const Vec3 wi = direction(60, 120);
  const float t_o = 1 - fresnel_dielectric(wo.z, 1.5f).reflectance;
  const float t_i = 1 - fresnel_dielectric(wi.z, 1.5f).reflectance;
  const float internal = diffuse_fresnel_reflectance(1 / 1.5f);
  EXPECT_NEAR(eval(*bsdf, wo, wi).x, 0.5f / (1 - internal) * t_o * t_i / 2.25f * wi.z * kInvPi,
              1e-6f);
  const auto nonlinear = build(PlasticBsdf{
      .int_ior = 1.5f, .ext_ior = 1, .diffuse_reflectance = {Color(0.5f)}, .nonlinear = true});
  EXPECT_NEAR(eval(*nonlinear, wo, wi).x,
              0.5f / (1 - 0.5f * internal) * t_o * t_i / 2.25f * wi.z * kInvPi, 1e-6f);
}

TEST(Plastic, RoughBecomesSmoothAwayFromTheHighlight) {
  const PlasticBsdf smooth{.int_ior = 1.5f, .ext_ior = 1};
  PlasticBsdf rough = smooth;
  rough.alpha = {0.01f};
  const float a = eval(*build(smooth), direction(20, 0), direction(50, 90)).x;
  EXPECT_NEAR(eval(*build(rough), direction(20, 0), direction(50, 90)).x / a, 1, 5e-3f);
}

TEST(Phong, IsMitsubasFormula) {
  const auto bsdf = build(PhongBsdf{.diffuse_reflectance = {Color(0.3f)},
                                    .specular_reflectance = {Color(0.6f)},
                                    .exponent = {20}});
  const Vec3 wi = direction(35, 180);
  const float cos_mirror = std::cos(5 * kPi / 180);
  EXPECT_NEAR(eval(*bsdf, direction(30, 0), wi).x,
              wi.z * kInvPi * (0.3f + 0.6f * 11 * std::pow(cos_mirror, 20.0f)), 1e-4f);
}

TEST(Phong, TooBrightSumsAreDimmed) {
  const auto bsdf = build(PhongBsdf{.diffuse_reflectance = {Color(0.9f)},
                                    .specular_reflectance = {Color(0.9f)},
                                    .exponent = {20}});
  EXPECT_NEAR(bsdf->albedo(flat_point(*bsdf)).x, 0.99f, 1e-5f);
}

TEST(Ward, VariantsDifferOnlyInTheirNormalisation) {
  const auto value = [](WardBsdf::Variant variant, Vec3 wo, Vec3 wi) {
    const auto bsdf = build(WardBsdf{.variant = variant, .diffuse_reflectance = {Color(0.0f)}});
    return eval(*bsdf, wo, wi).x / wi.z;
  };
  using Variant = WardBsdf::Variant;
  const Vec3 wo = direction(50, 0);
  const Vec3 wi = direction(40, 190);
  const float ward = value(Variant::Ward, wo, wi);
  const float duer = value(Variant::WardDuer, wo, wi);
  EXPECT_NEAR(duer / ward, 1 / std::sqrt(wo.z * wi.z), 1e-3f);
  const Vec3 h = wo + wi;
  EXPECT_NEAR(value(Variant::Balanced, wo, wi) / duer,
              4 * wo.z * wi.z * glm::dot(h, h) / sqr(sqr(h.z)), 1e-3f);
}

TEST(Coating, AbsorbsAlongTheSlantedPath) {
  const DiffuseBsdf base{.reflectance = {Color(0.5f)}};
  CoatingBsdf coat{.nested = 0, .int_ior = 1.5f, .ext_ior = 1, .thickness = 2};
  const float clear = eval(*build(base, coat), kUp, kUp).x;
  EXPECT_NEAR(clear, 0.96f * 0.96f * 0.5f * kInvPi / 2.25f, 1e-5f);
  coat.sigma_a = {Color(0.25f)};
  // Straight down and up again: twice the thickness.
  EXPECT_NEAR(eval(*build(base, coat), kUp, kUp).x, clear * std::exp(-1.0f), 1e-5f);
}

TEST(Blend, WeightIsThatOfTheSecond) {
  const auto bsdf =
      build(DiffuseBsdf{.reflectance = {Color(1.0f)}}, DiffuseBsdf{.reflectance = {Color(0.0f)}},
            BlendBsdf{.weight = {0.25f}, .first = 0, .second = 1});
  EXPECT_FLOAT_EQ(eval(*bsdf, kUp, kUp).x, 0.75f * kInvPi);
}

TEST(Blend, TwoInteriorsAreAnError) {
  const DielectricBsdf glass{.int_ior = 1.5f, .ext_ior = 1};
  const DielectricBsdf water{.int_ior = 1.33f, .ext_ior = 1};
  EXPECT_THROW(build(glass, water, BlendBsdf{.first = 0, .second = 1}), Error);
  EXPECT_EQ(build(glass, DiffuseBsdf{}, BlendBsdf{.first = 1, .second = 0})->eta(), 1.5f);
}

TEST(TwoSided, UsesTheBackForTheBack) {
  const auto bsdf =
      build(DiffuseBsdf{.reflectance = {Color(0.2f)}}, DiffuseBsdf{.reflectance = {Color(0.8f)}},
            TwoSidedBsdf{.front = 0, .back = 1});
  EXPECT_FLOAT_EQ(eval(*bsdf, kUp, kUp).x, 0.2f * kInvPi);
  EXPECT_FLOAT_EQ(eval(*bsdf, -kUp, -kUp).x, 0.8f * kInvPi);
  EXPECT_EQ(eval(*bsdf, kUp, -kUp).x, 0);
}

TEST(TwoSided, LeavesGlassAsItIs) {
  const auto bsdf =
      build(DielectricBsdf{.int_ior = 1.5f, .ext_ior = 1}, TwoSidedBsdf{.front = 0, .back = 0});
  // Totally reflected inside, which a back turned into a front would not be.
  EXPECT_FALSE(bsdf->specular(flat_point(*bsdf), direction(130, 0), kLobeDeltaTransmission));
}

TEST(Mask, OpacityOutsideTheUnitIntervalIsClamped) {
  for (const float opacity : {-1.0f, 2.0f}) {
    const auto bsdf = build(DiffuseBsdf{}, MaskBsdf{.opacity = {opacity}, .nested = 0});
    const auto drawn = bsdf->sample(flat_point(*bsdf), kUp, 0.5f, Vec2(0.5f));
    EXPECT_EQ(drawn->is_delta(), opacity < 0);
    EXPECT_LE(bsdf->pdf(flat_point(*bsdf), kUp, kUp), kInvPi);
  }
}

TEST(MakeBsdfs, NamesTheBsdfThatRefersToNothing) {
  SceneDescription scene;
  scene.path = "test.xml";
  scene.bsdfs.push_back({.name = "curtain", .line = 12, .model = MaskBsdf{.nested = 3}});
  try {
    make_bsdfs(scene, {});
    FAIL();
  } catch (const Error& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("test.xml:12"), std::string::npos) << message;
    EXPECT_NE(message.find("curtain"), std::string::npos) << message;
  }
}

TEST(MakeBsdfs, RefusesImpossibleInput) {
  EXPECT_THROW(build(DielectricBsdf{.int_ior = 0}), Error);
  EXPECT_THROW(build(DielectricBsdf{.int_ior = 1.5f, .ext_ior = -1}), Error);
  EXPECT_THROW(build(DiffuseBsdf{.reflectance = {Color(1.0f), 5}}), Error);
  EXPECT_THROW(build(DiffuseBsdf{}, NormalMapBsdf{.texture = 0, .nested = 0}), Error);
}

}  // namespace
}  // namespace guidelight::bsdf_test

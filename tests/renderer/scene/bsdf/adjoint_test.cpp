#include <gtest/gtest.h>

#include "renderer/sampling/random.h"
#include "renderer/sampling/warp.h"
#include "renderer/scene/bsdf/scattering.h"
#include "tests/renderer/scene/bsdf/bsdf_cases.h"

/// Symmetry of the BSDFs themselves, and the two ways in which Scattering breaks it on purpose.
namespace guidelight::bsdf_test {
namespace {

/// IOR on the side of w, relative to the outside.
float side_ior(const Bsdf& bsdf, Vec3 w) { return w.z > 0 ? 1.0f : bsdf.eta(); }

void expect_equal(Color a, Color b, float tolerance = 2e-3f) {
  const float scale = std::max(max_component(glm::abs(a)), 1e-4f);
  EXPECT_LT(max_component(glm::abs(a - b)), tolerance * scale)
      << a.x << ' ' << a.y << ' ' << a.z << " against " << b.x << ' ' << b.y << ' ' << b.z;
}

/// Calls check(wo, wi) for pairs of directions of which about half are likely ones.
template <typename Check>
void for_pairs(const Bsdf& bsdf, const SurfacePoint& point, Check check) {
  Rng rng(21, 0, 0);
  for (int i = 0; i < 3000; ++i) {
    const Vec3 wo = square_to_sphere(rng.next_vec2());
    Vec3 wi = square_to_sphere(rng.next_vec2());
    const float u_lobe = rng.next_float();
    const auto drawn = bsdf.sample(point, wo, u_lobe, rng.next_vec2());
    if (i % 2 == 0 && drawn && !drawn->is_delta()) wi = drawn->wi;
    // Grazing directions divide rounding errors by next to nothing.
    if (std::abs(wo.z) > 0.05f && std::abs(wi.z) > 0.05f) check(wo, wi);
  }
}

class BsdfAdjoint : public ::testing::TestWithParam<Case> {
 protected:
  std::shared_ptr<const Bsdf> bsdf_ = GetParam().build();
};

TEST_P(BsdfAdjoint, FluxFormIsReciprocalUpToTheSquaredIor) {
  // f(wo, wi)/η_wi² = f(wi, wo)/η_wo² (Veach 1997, 5.14); η is the same on both sides of a
  // reflection.
  const SurfacePoint point = flat_point(*bsdf_);
  for_pairs(*bsdf_, point, [&](Vec3 wo, Vec3 wi) {
    const Color forward = bsdf_->eval(point, wo, wi) / std::abs(wi.z);
    const Color backward = bsdf_->eval(point, wi, wo) / std::abs(wo.z);
    expect_equal(forward / sqr(side_ior(*bsdf_, wi)), backward / sqr(side_ior(*bsdf_, wo)));
  });
}

TEST_P(BsdfAdjoint, DeltaEventsAreReversible) {
  const SurfacePoint point = flat_point(*bsdf_);
  Rng rng(22, 0, 0);
  for (int i = 0; i < 500; ++i) {
    const Vec3 wo = square_to_sphere(rng.next_vec2());
    for (const Lobe lobe : {kLobeDeltaReflection, kLobeDeltaTransmission}) {
      const auto event = bsdf_->specular(point, wo, lobe);
      if (!event || std::abs(wo.z) < 0.05f || std::abs(event->wi.z) < 0.05f) continue;
      const auto back = bsdf_->specular(point, event->wi, lobe);
      // Where there are two transmissions the likelier may differ between the two sides.
      if (!back || glm::length(back->wi - wo) > 1e-2f) {
        EXPECT_EQ(lobe, kLobeDeltaTransmission);
        EXPECT_TRUE(GetParam().name.starts_with("mask") || GetParam().name.starts_with("blend"));
        continue;
      }
      EXPECT_NEAR(event->eta * back->eta, 1, 1e-5f);
      expect_equal(event->value, back->value, 1e-2f);
    }
  }
}

TEST_P(BsdfAdjoint, ImportanceIsTheTransposeOfRadiance) {
  // A connection through the point contributes f(wo, wi)·|wi·ng| whichever end carries radiance:
  // value_radiance(wo → wi) is f(wo, wi)·|wi·ns| and value_importance(wi → wo) must be
  // f(wo, wi)·|wi·ns||wo·ng|/|wi·ng|, the path having come from wi (Veach 1997, 5.19).
  SurfacePoint point = flat_point(*bsdf_);
  point.frame = Frame::from_normal_and_tangent(direction(50, 70), Vec3(1, 0, 0));
  point.geometric_normal = point.frame.to_world(direction(15, 120));
  for_pairs(*bsdf_, point, [&](Vec3 wo_local, Vec3 wi_local) {
    const Vec3 wo = point.frame.to_world(wo_local);
    const Vec3 wi = point.frame.to_world(wi_local);
    const Color radiance = Scattering(point, wo, TransportMode::Radiance).value(wi);
    const Color importance = Scattering(point, wi, TransportMode::Importance).value(wo);
    const float cos_o = std::abs(glm::dot(wo, point.geometric_normal));
    const float cos_i = std::abs(glm::dot(wi, point.geometric_normal));
    if (cos_o < 0.05f || cos_i < 0.05f) return;
    expect_equal(radiance * cos_o / cos_i, importance);
  });
}

INSTANTIATE_TEST_SUITE_P(EveryBsdf, BsdfAdjoint, ::testing::ValuesIn(all_cases()),
                         [](const auto& test) { return test.param.name; });

TEST(Scattering, RadianceIsCompressedOnEntryAndImportanceIsNot) {
  const auto bsdf = build(DielectricBsdf{.int_ior = 1.5f, .ext_ior = 1});
  const SurfacePoint point = flat_point(*bsdf);
  const auto weight = [&](Vec3 wo, TransportMode mode) {
    return Scattering(point, wo, mode).sample(0.99f, Vec2(0.5f))->weight.x;
  };
  // A camera path that enters glass sees radiance that was compressed inside: divided by 1.5².
  EXPECT_FLOAT_EQ(weight(Vec3(0, 0, 1), TransportMode::Radiance), 1 / 2.25f);
  EXPECT_FLOAT_EQ(weight(Vec3(0, 0, -1), TransportMode::Radiance), 2.25f);
  EXPECT_FLOAT_EQ(weight(Vec3(0, 0, 1), TransportMode::Importance), 1);
  EXPECT_FLOAT_EQ(weight(Vec3(0, 0, -1), TransportMode::Importance), 1);
}

TEST(Scattering, LeaksAreRejectedTheSameWayFromBothEnds) {
  const auto bsdf = build(DiffuseBsdf{}, TwoSidedBsdf{.front = 0, .back = 0});
  SurfacePoint point = flat_point(*bsdf);
  point.geometric_normal = direction(30, 0);
  const Vec3 good = direction(20, 50);
  const Vec3 leak = direction(80, 180);  // above the shading surface, below the geometric one
  ASSERT_LT(glm::dot(leak, point.geometric_normal), 0);
  for (const TransportMode mode : {TransportMode::Radiance, TransportMode::Importance}) {
    EXPECT_GT(Scattering(point, good, mode).value(good).x, 0);
    EXPECT_EQ(Scattering(point, good, mode).value(leak).x, 0);
    EXPECT_EQ(Scattering(point, leak, mode).value(good).x, 0);
    EXPECT_EQ(Scattering(point, good, mode).pdf(leak), 0);
    EXPECT_EQ(Scattering(point, good, mode).pdf_reverse(leak), 0);
    EXPECT_FALSE(Scattering(point, leak, mode).sample(0.5f, Vec2(0.5f)));
  }
}

TEST(Scattering, StraightPassesIgnoreTheShadingNormal) {
  const auto bsdf = build(NullBsdf{});
  SurfacePoint point = flat_point(*bsdf);
  point.geometric_normal = direction(30, 0);
  const Vec3 wo = direction(80, 180);
  for (const TransportMode mode : {TransportMode::Radiance, TransportMode::Importance}) {
    const auto drawn = Scattering(point, wo, mode).sample(0.5f, Vec2(0.5f));
    ASSERT_TRUE(drawn);
    EXPECT_EQ(drawn->wi, -wo);
    EXPECT_EQ(drawn->weight, Color(1.0f));
  }
}

}  // namespace
}  // namespace guidelight::bsdf_test

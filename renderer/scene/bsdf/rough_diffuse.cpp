#include <algorithm>

#include "renderer/sampling/warp.h"
#include "renderer/scene/bsdf/factories.h"

namespace guidelight {
namespace {

/// The full model of Oren & Nayar 1994, "Generalization of Lambert's Reflectance Model" (equation
/// numbers below), on the outside only: V-shaped grooves of Lambertian facets whose tilt has
/// standard deviation σ, with one interreflection.
class RoughDiffuse final : public Bsdf {
 public:
  RoughDiffuse(ColorTexture reflectance, FloatTexture alpha)
      : reflectance_(std::move(reflectance)), alpha_(std::move(alpha)) {}

  BsdfEvaluation evaluate(const SurfacePoint& point, Vec3 wo, Vec3 wi) const override {
    if (wo.z <= 0 || wi.z <= 0) return {};
    const float theta_i = std::acos(std::min(wi.z, 1.0f));
    const float theta_o = std::acos(std::min(wo.z, 1.0f));
    const float alpha = std::max(theta_i, theta_o);
    const float beta = std::min(theta_i, theta_o);
    const float cos_phi = cos_azimuth(wo, wi);
    const float sigma2 = 0.5f * sqr(alpha_.eval(point));  // of a Beckmann surface of roughness α

    const float c1 = 1 - 0.5f * sigma2 / (sigma2 + 0.33f);
    const float backward = cos_phi >= 0 ? 0.0f : cube(2 * beta * kInvPi);
    const float c2 = 0.45f * sigma2 / (sigma2 + 0.09f) * (std::sin(alpha) - backward);
    const float c3 = 0.125f * sigma2 / (sigma2 + 0.09f) * sqr(4 * alpha * beta * kInvPi * kInvPi);
    const float direct = c1 + c2 * cos_phi * std::tan(beta) +
                         c3 * (1 - std::abs(cos_phi)) * std::tan(0.5f * (alpha + beta));  // (27)
    const float interreflected =
        0.17f * sigma2 / (sigma2 + 0.13f) * (1 - cos_phi * sqr(2 * beta * kInvPi));  // (28)
    const Color rho = reflectance_.eval(point);
    const float pdf = wi.z * kInvPi;
    return {rho * (direct + rho * interreflected) * pdf, pdf, wo.z * kInvPi};
  }

  std::optional<BsdfSample> sample(const SurfacePoint& point, Vec3 wo, float,
                                   Vec2 u) const override {
    if (wo.z <= 0) return std::nullopt;
    const Vec3 wi = square_to_cosine_hemisphere(u);
    if (wi.z <= 0) return std::nullopt;
    const BsdfEvaluation drawn = evaluate(point, wo, wi);
    return BsdfSample{wi, drawn.value / drawn.pdf, drawn.pdf, 1.0f, kLobeDiffuse};
  }

  int lobes() const override { return kLobeDiffuse; }
  Color albedo(const SurfacePoint& point) const override { return reflectance_.eval(point); }

 private:
  static float cube(float x) { return x * x * x; }
  static float cos_azimuth(Vec3 a, Vec3 b) {
    const float lengths2 = sin2_theta(a) * sin2_theta(b);
    if (lengths2 < 1e-12f) return 1;
    return std::clamp((a.x * b.x + a.y * b.y) / std::sqrt(lengths2), -1.0f, 1.0f);
  }

  ColorTexture reflectance_;
  FloatTexture alpha_;
};

}  // namespace

BsdfPointer make_bsdf(const RoughDiffuseBsdf& description, const BsdfContext& context) {
  return std::make_shared<RoughDiffuse>(context.color(description.reflectance),
                                        context.scalar(description.alpha));
}

}  // namespace guidelight

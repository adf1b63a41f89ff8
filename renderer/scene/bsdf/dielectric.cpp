#include "renderer/scene/bsdf/clear_interface.h"
#include "renderer/scene/bsdf/microfacet.h"

namespace guidelight {
namespace {

/// Mirror and refraction, as much of each as Fresnel says.
class SmoothDielectric final : public ClearInterface {
 public:
  SmoothDielectric(float eta, ColorTexture reflectance, ColorTexture transmittance)
      : ClearInterface(std::move(reflectance), std::move(transmittance)), eta_(eta) {}

  float eta() const override { return eta_; }

 private:
  Split split(Vec3 wo) const override {
    const DielectricFresnel fresnel = fresnel_dielectric(wo.z, eta_);
    return {fresnel.reflectance, refract(wo, fresnel), fresnel.eta};
  }

  float eta_;
};

/// Rough interface of Walter et al. 2007. In the flux form f(wo, wi)/η_wi² is symmetric, where η_wi
/// is the IOR on the side of wi.
class RoughDielectric final : public Bsdf {
 public:
  RoughDielectric(float eta, ColorTexture reflectance, ColorTexture transmittance,
                  FloatTexture alpha_u, FloatTexture alpha_v, Microfacet kind)
      : eta_(eta),
        reflectance_(std::move(reflectance)),
        transmittance_(std::move(transmittance)),
        alpha_u_(std::move(alpha_u)),
        alpha_v_(std::move(alpha_v)),
        kind_(kind) {}

  BsdfEvaluation evaluate(const SurfacePoint& point, Vec3 wo, Vec3 wi) const override {
    const std::optional<Facet> facet = facet_between(wo, wi);
    if (!facet) return {};
    const MicrofacetDistribution facets = distribution(point);
    // Fresnel's reflectance is the same from the other side.
    const float reflected = fresnel_dielectric(facet->cos_o, eta_).reflectance;
    const float density =
        facets.density(facet->m) * (facet->is_reflection ? reflected : 1 - reflected);
    const float visible_i = facets.masking(wi, facet->m);
    const float pdf =
        density * facets.masking(wo, facet->m) * std::abs(facet->cos_o / wo.z) * facet->jacobian;
    const ColorTexture& color = facet->is_reflection ? reflectance_ : transmittance_;
    return {pdf * visible_i * color.eval(point), pdf,  // (20), (21)
            density * visible_i * std::abs(facet->cos_i / wi.z) * facet->jacobian_reverse};
  }

  std::optional<BsdfSample> sample(const SurfacePoint& point, Vec3 wo, float u_lobe,
                                   Vec2 u) const override {
    if (wo.z == 0) return std::nullopt;
    const MicrofacetDistribution facets = distribution(point);
    const float side = std::copysign(1.0f, wo.z);
    const Vec3 m = facets.sample_visible(side * wo, u);
    const float cos_o = glm::dot(wo, m);
    const DielectricFresnel fresnel = fresnel_dielectric(cos_o, eta_);
    const bool is_reflection = u_lobe < fresnel.reflectance;
    const Vec3 wi = is_reflection ? reflect(wo, m) : refract(wo, m, fresnel);
    const float density = facets.pdf_visible(side * wo, m);
    if (same_hemisphere(wo, wi) != is_reflection || !(density > 0)) return std::nullopt;
    const float shadowing = facets.masking(wi, m);
    if (is_reflection) {
      return BsdfSample{wi, shadowing * reflectance_.eval(point),
                        fresnel.reflectance * density / (4 * std::abs(cos_o)), 1.0f, kLobeGlossy};
    }
    return BsdfSample{wi, shadowing * transmittance_.eval(point),
                      (1 - fresnel.reflectance) * density *
                          refraction_jacobian(cos_o, glm::dot(wi, m), fresnel.eta),
                      fresnel.eta, kLobeGlossy};
  }

  int lobes() const override { return kLobeGlossy; }
  float eta() const override { return eta_; }
  Color albedo(const SurfacePoint& point) const override {
    return glm::max(reflectance_.eval(point), transmittance_.eval(point));
  }

 private:
  /// The microfacet that sends wo to wi; its normal is on the outside.
  struct Facet {
    Vec3 m;
    float cos_o;             // wo·m
    float cos_i;             // wi·m
    float jacobian;          // dω_m / dω_wi
    float jacobian_reverse;  // dω_m / dω_wo
    bool is_reflection;
  };

  std::optional<Facet> facet_between(Vec3 wo, Vec3 wi) const {
    if (wo.z == 0 || wi.z == 0) return std::nullopt;
    const bool is_reflection = same_hemisphere(wo, wi);
    const float ratio = is_reflection ? 1.0f : wo.z > 0 ? eta_ : 1 / eta_;
    Vec3 m = wo + ratio * wi;  // (13), (16)
    if (m.z < 0) m = -m;
    const float squared = length_squared(m);
    if (squared == 0) return std::nullopt;
    m /= std::sqrt(squared);
    const float cos_o = glm::dot(wo, m);
    const float cos_i = glm::dot(wi, m);
    if (cos_o * wo.z <= 0 || cos_i * wi.z <= 0) return std::nullopt;  // seen from behind
    if (is_reflection) {
      const float jacobian = 1 / (4 * std::abs(cos_i));  // (14)
      return Facet{m, cos_o, cos_i, jacobian, jacobian, true};
    }
    return Facet{m,
                 cos_o,
                 cos_i,
                 refraction_jacobian(cos_o, cos_i, ratio),
                 refraction_jacobian(cos_i, cos_o, 1 / ratio),
                 false};
  }

  /// (17); `ratio` is the IOR on the side of wi over that on the side of wo.
  static float refraction_jacobian(float cos_o, float cos_i, float ratio) {
    return sqr(ratio) * std::abs(cos_i) / sqr(cos_o + ratio * cos_i);
  }

  MicrofacetDistribution distribution(const SurfacePoint& point) const {
    return {kind_, alpha_u_.eval(point), alpha_v_.eval(point)};
  }

  float eta_;
  ColorTexture reflectance_;
  ColorTexture transmittance_;
  FloatTexture alpha_u_;
  FloatTexture alpha_v_;
  Microfacet kind_;
};

}  // namespace

BsdfPointer make_bsdf(const DielectricBsdf& description, const BsdfContext& context) {
  const float eta = context.relative_ior(description.int_ior, description.ext_ior);
  ColorTexture reflectance = context.color(description.specular_reflectance);
  ColorTexture transmittance = context.color(description.specular_transmittance);
  FloatTexture alpha_u = context.scalar(description.alpha_u);
  FloatTexture alpha_v = context.scalar(description.alpha_v);
  // Without a step of the IOR a rough interface bends nothing, and no facet explains a direction.
  const bool is_matched = std::abs(eta - 1) < 1e-3f;
  if (is_matched || (is_smooth(alpha_u) && is_smooth(alpha_v))) {
    return std::make_shared<SmoothDielectric>(eta, std::move(reflectance),
                                              std::move(transmittance));
  }
  return std::make_shared<RoughDielectric>(eta, std::move(reflectance), std::move(transmittance),
                                           std::move(alpha_u), std::move(alpha_v),
                                           description.distribution);
}

}  // namespace guidelight

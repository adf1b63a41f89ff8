#include "renderer/scene/bsdf/factories.h"
#include "renderer/scene/bsdf/fresnel.h"
#include "renderer/scene/bsdf/microfacet.h"

namespace guidelight {
namespace {

/// Complex IOR and colour, common to the smooth and the rough metal.
struct Metal {
  Color eta;
  Color k;
  ColorTexture specular_reflectance;
  Color at_60 = fresnel_conductor(0.5f, eta, k);

  Color reflectance(const SurfacePoint& point, float cos_theta) const {
    return specular_reflectance.eval(point) * fresnel_conductor(cos_theta, eta, k);
  }
  /// At 60°, where half of a diffusely lit surface's light comes from beyond.
  Color albedo(const SurfacePoint& point) const { return specular_reflectance.eval(point) * at_60; }
};

class SmoothConductor final : public Bsdf {
 public:
  explicit SmoothConductor(Metal metal) : metal_(std::move(metal)) {}

  BsdfEvaluation evaluate(const SurfacePoint&, Vec3, Vec3) const override { return {}; }

  std::optional<BsdfSample> sample(const SurfacePoint& point, Vec3 wo, float, Vec2) const override {
    if (wo.z <= 0) return std::nullopt;
    return BsdfSample{reflect(wo), metal_.reflectance(point, wo.z), 1.0f, 1.0f,
                      kLobeDeltaReflection};
  }

  std::optional<SpecularEvent> specular(const SurfacePoint& point, Vec3 wo,
                                        Lobe lobe) const override {
    if (wo.z <= 0 || lobe != kLobeDeltaReflection) return std::nullopt;
    return SpecularEvent{reflect(wo), metal_.reflectance(point, wo.z), 1.0f};
  }

  int lobes() const override { return kLobeDeltaReflection; }
  Color albedo(const SurfacePoint& point) const override { return metal_.albedo(point); }

 private:
  Metal metal_;
};

/// Walter et al. 2007 with F of the metal.
class RoughConductor final : public Bsdf {
 public:
  RoughConductor(Metal metal, FloatTexture alpha_u, FloatTexture alpha_v, Microfacet kind)
      : metal_(std::move(metal)),
        alpha_u_(std::move(alpha_u)),
        alpha_v_(std::move(alpha_v)),
        kind_(kind) {}

  BsdfEvaluation evaluate(const SurfacePoint& point, Vec3 wo, Vec3 wi) const override {
    if (wo.z <= 0 || wi.z <= 0) return {};
    const Vec3 m = glm::normalize(wo + wi);
    const FacetReflection facet = distribution(point).reflection(wo, wi, m);
    return {facet.value * metal_.reflectance(point, glm::dot(wi, m)), facet.pdf, facet.pdf_reverse};
  }

  std::optional<BsdfSample> sample(const SurfacePoint& point, Vec3 wo, float,
                                   Vec2 u) const override {
    if (wo.z <= 0) return std::nullopt;
    const MicrofacetDistribution facets = distribution(point);
    const Vec3 m = facets.sample_visible(wo, u);
    const float cos_om = glm::dot(wo, m);
    const Vec3 wi = reflect(wo, m);
    const float pdf = facets.pdf_visible(wo, m) / (4 * cos_om);
    if (wi.z <= 0 || !(pdf > 0)) return std::nullopt;
    // Visible normals cancel everything but the masking of the new direction.
    return BsdfSample{wi, metal_.reflectance(point, cos_om) * facets.masking(wi, m), pdf, 1.0f,
                      kLobeGlossy};
  }

  int lobes() const override { return kLobeGlossy; }
  Color albedo(const SurfacePoint& point) const override { return metal_.albedo(point); }

 private:
  MicrofacetDistribution distribution(const SurfacePoint& point) const {
    return {kind_, alpha_u_.eval(point), alpha_v_.eval(point)};
  }

  Metal metal_;
  FloatTexture alpha_u_;
  FloatTexture alpha_v_;
  Microfacet kind_;
};

}  // namespace

BsdfPointer make_bsdf(const ConductorBsdf& description, const BsdfContext& context) {
  Metal metal{description.eta, description.k, context.color(description.specular_reflectance)};
  FloatTexture alpha_u = context.scalar(description.alpha_u);
  FloatTexture alpha_v = context.scalar(description.alpha_v);
  if (is_smooth(alpha_u) && is_smooth(alpha_v)) {
    return std::make_shared<SmoothConductor>(std::move(metal));
  }
  return std::make_shared<RoughConductor>(std::move(metal), std::move(alpha_u), std::move(alpha_v),
                                          description.distribution);
}

}  // namespace guidelight

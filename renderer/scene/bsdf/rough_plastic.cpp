#include "renderer/sampling/warp.h"
#include "renderer/scene/bsdf/fresnel.h"
#include "renderer/scene/bsdf/plastic.h"
#include "renderer/scene/bsdf/rough_interface.h"

namespace guidelight {
namespace {

/// Rough dielectric coat over a diffuse base, on the outside only: the base is lit and seen through
/// what the rough interface lets pass in all directions together.
class RoughPlastic final : public Bsdf {
 public:
  RoughPlastic(float eta, PlasticBase base, ColorTexture specular, FloatTexture alpha,
               Microfacet kind, RoughInterface interface)
      : eta_(eta),
        specular_weight_(specular_sampling_weight(base.reflectance, specular)),
        base_(std::move(base)),
        specular_(std::move(specular)),
        alpha_(std::move(alpha)),
        kind_(kind),
        interface_(std::move(interface)) {}

  BsdfEvaluation evaluate(const SurfacePoint& point, Vec3 wo, Vec3 wi) const override {
    if (wo.z <= 0 || wi.z <= 0) return {};
    const float alpha = alpha_.eval(point);
    const Vec3 m = glm::normalize(wo + wi);
    const FacetReflection facet = MicrofacetDistribution(kind_, alpha, alpha).reflection(wo, wi, m);
    const float specular = fresnel_dielectric(glm::dot(wo, m), eta_).reflectance * facet.value;
    const float through_o = interface_.transmittance(wo.z, alpha);
    const float through_i = interface_.transmittance(wi.z, alpha);
    const float diffuse = through_o * through_i * wi.z * kInvPi;
    return {specular * specular_.eval(point) + diffuse * base_.eval(point),
            glm::mix(wi.z * kInvPi, facet.pdf, specular_probability(through_o)),
            glm::mix(wo.z * kInvPi, facet.pdf_reverse, specular_probability(through_i))};
  }

  std::optional<BsdfSample> sample(const SurfacePoint& point, Vec3 wo, float u_lobe,
                                   Vec2 u) const override {
    if (wo.z <= 0) return std::nullopt;
    const float alpha = alpha_.eval(point);
    if (u_lobe >= specular_probability(interface_.transmittance(wo.z, alpha))) {
      return sample_of_all_lobes(*this, point, wo, square_to_cosine_hemisphere(u), kLobeDiffuse);
    }
    const Vec3 m = MicrofacetDistribution(kind_, alpha, alpha).sample_visible(wo, u);
    return sample_of_all_lobes(*this, point, wo, reflect(wo, m), kLobeGlossy);
  }

  int lobes() const override { return kLobeDiffuse | kLobeGlossy; }
  Color albedo(const SurfacePoint& point) const override { return base_.reflectance.eval(point); }

 private:
  float specular_probability(float transmittance) const {
    return coat_probability(1 - transmittance, specular_weight_);
  }

  float eta_;
  float specular_weight_;
  PlasticBase base_;
  ColorTexture specular_;
  FloatTexture alpha_;
  Microfacet kind_;
  RoughInterface interface_;
};

}  // namespace

BsdfPointer make_rough_plastic(const PlasticBsdf& description, const BsdfContext& context) {
  const float eta = context.relative_ior(description.int_ior, description.ext_ior);
  FloatTexture alpha = context.scalar(description.alpha);
  const float mean_alpha = std::max(alpha.mean(), kMinAlpha);
  RoughInterface interface(description.distribution, eta,
                           alpha.is_constant() ? mean_alpha : kMinAlpha,
                           alpha.is_constant() ? mean_alpha : 1.0f);
  PlasticBase base{context.color(description.diffuse_reflectance),
                   diffuse_rough_reflectance(description.distribution, 1 / eta, mean_alpha), eta,
                   description.nonlinear};
  return std::make_shared<RoughPlastic>(
      eta, std::move(base), context.color(description.specular_reflectance), std::move(alpha),
      description.distribution, std::move(interface));
}

}  // namespace guidelight

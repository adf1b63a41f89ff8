#include "renderer/scene/bsdf/plastic.h"

#include "renderer/sampling/warp.h"
#include "renderer/scene/bsdf/fresnel.h"
#include "renderer/scene/bsdf/microfacet.h"

namespace guidelight {
namespace {

/// Smooth dielectric coat over a diffuse base, on the outside only.
class SmoothPlastic final : public Bsdf {
 public:
  SmoothPlastic(float eta, PlasticBase base, ColorTexture specular)
      : eta_(eta),
        specular_weight_(specular_sampling_weight(base.reflectance, specular)),
        base_(std::move(base)),
        specular_(std::move(specular)) {}

  BsdfEvaluation evaluate(const SurfacePoint& point, Vec3 wo, Vec3 wi) const override {
    if (wo.z <= 0 || wi.z <= 0) return {};
    const float through_o = transmittance(wo);
    const float through_i = transmittance(wi);
    return {base_.eval(point) * (through_o * through_i * wi.z * kInvPi),
            (1 - specular_probability(1 - through_o)) * wi.z * kInvPi,
            (1 - specular_probability(1 - through_i)) * wo.z * kInvPi};
  }

  std::optional<BsdfSample> sample(const SurfacePoint& point, Vec3 wo, float u_lobe,
                                   Vec2 u) const override {
    if (wo.z <= 0) return std::nullopt;
    const float reflected = 1 - transmittance(wo);
    const float p_specular = specular_probability(reflected);
    if (u_lobe < p_specular) {
      return BsdfSample{reflect(wo), specular_.eval(point) * (reflected / p_specular), p_specular,
                        1.0f, kLobeDeltaReflection};
    }
    const Vec3 wi = square_to_cosine_hemisphere(u);
    if (wi.z <= 0) return std::nullopt;
    const float p_diffuse = 1 - p_specular;
    return BsdfSample{wi, base_.eval(point) * ((1 - reflected) * transmittance(wi) / p_diffuse),
                      p_diffuse * wi.z * kInvPi, 1.0f, kLobeDiffuse};
  }

  std::optional<SpecularEvent> specular(const SurfacePoint& point, Vec3 wo,
                                        Lobe lobe) const override {
    if (wo.z <= 0 || lobe != kLobeDeltaReflection) return std::nullopt;
    const float reflected = 1 - transmittance(wo);
    const float p_specular = specular_probability(reflected);
    if (p_specular == 0) return std::nullopt;
    return SpecularEvent{reflect(wo), reflected * specular_.eval(point), p_specular};
  }

  int lobes() const override { return kLobeDeltaReflection | kLobeDiffuse; }
  Color albedo(const SurfacePoint& point) const override { return base_.reflectance.eval(point); }

 private:
  float transmittance(Vec3 w) const { return 1 - fresnel_dielectric(w.z, eta_).reflectance; }
  float specular_probability(float reflected) const {
    return coat_probability(reflected, specular_weight_);
  }

  float eta_;
  float specular_weight_;
  PlasticBase base_;
  ColorTexture specular_;
};

}  // namespace

BsdfPointer make_bsdf(const PlasticBsdf& description, const BsdfContext& context) {
  if (!is_smooth(context.scalar(description.alpha)))
    return make_rough_plastic(description, context);
  const float eta = context.relative_ior(description.int_ior, description.ext_ior);
  PlasticBase base{context.color(description.diffuse_reflectance),
                   diffuse_fresnel_reflectance(1 / eta), eta, description.nonlinear};
  return std::make_shared<SmoothPlastic>(eta, std::move(base),
                                         context.color(description.specular_reflectance));
}

}  // namespace guidelight

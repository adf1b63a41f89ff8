#include "renderer/scene/bsdf/factories.h"
#include "renderer/scene/bsdf/fresnel.h"

namespace guidelight {
namespace {

/// A smooth dielectric layer over another BSDF. Light is reflected by the layer's surface or
/// crosses it, is absorbed on its slanted way, meets the nested BSDF once and crosses out again;
/// reflections inside the layer are neglected. Transmission by the nested BSDF is not supported and
/// absorbs.
class Coating final : public Bsdf {
 public:
  Coating(float eta, BsdfPointer nested, ColorTexture absorption, ColorTexture specular)
      : eta_(eta),
        nested_(std::move(nested)),
        absorption_(std::move(absorption)),
        specular_(std::move(specular)) {
    const Color mean = glm::exp(-2.0f * absorption_.mean());
    specular_weight_ = 1 / (1 + (mean.r + mean.g + mean.b) / 3);
  }

  BsdfEvaluation evaluate(const SurfacePoint& point, Vec3 wo, Vec3 wi) const override {
    if (!same_hemisphere(wo, wi)) return {};
    const Crossing out = enter(wo);
    const Crossing in = enter(wi);
    if (out.reflected == 1 || in.reflected == 1) return {};
    BsdfEvaluation result = nested_->evaluate(point, out.inside, in.inside);
    const float ratio = solid_angle_ratio(wi, in);
    result.value *= attenuation(point, out, in) * ratio;
    result.pdf *= (1 - specular_probability(out.reflected)) * ratio;
    result.pdf_reverse *= (1 - specular_probability(in.reflected)) * solid_angle_ratio(wo, out);
    return result;
  }

  std::optional<BsdfSample> sample(const SurfacePoint& point, Vec3 wo, float u_lobe,
                                   Vec2 u) const override {
    if (wo.z == 0) return std::nullopt;
    const Crossing out = enter(wo);
    const float p_specular = specular_probability(out.reflected);
    if (u_lobe < p_specular) return mirror_sample(point, wo);
    std::optional<BsdfSample> drawn =
        nested_->sample(point, out.inside, reuse_above(u_lobe, p_specular), u);
    if (!drawn || !same_hemisphere(wo, drawn->wi)) return std::nullopt;
    if (drawn->is_delta()) return mirror_sample(point, wo);
    const std::optional<Vec3> wi = leave(drawn->wi);
    if (!wi) return std::nullopt;
    const Crossing in = enter(*wi);
    const float p_nested = 1 - p_specular;
    drawn->wi = *wi;
    drawn->weight *= attenuation(point, out, in) / p_nested;
    drawn->pdf *= p_nested * solid_angle_ratio(*wi, in);
    return drawn;
  }

  /// The mirror of the layer's surface and that of the nested BSDF are one event.
  std::optional<SpecularEvent> specular(const SurfacePoint& point, Vec3 wo,
                                        Lobe lobe) const override {
    if (wo.z == 0 || lobe != kLobeDeltaReflection) return std::nullopt;
    const Crossing out = enter(wo);
    const float p_specular = specular_probability(out.reflected);
    SpecularEvent event{reflect(wo), out.reflected * specular_.eval(point), p_specular};
    if (out.reflected == 1) return event;
    if (const auto below = nested_->specular(point, out.inside, lobe)) {
      event.value += below->value * attenuation(point, out, out);
      event.probability += (1 - p_specular) * below->probability;
    }
    return event;
  }

  int lobes() const override {
    return kLobeDeltaReflection | (nested_->lobes() & ~kLobeDeltaTransmission);
  }
  Color albedo(const SurfacePoint& point) const override {
    return nested_->albedo(point) * glm::exp(-2.0f * absorption_.eval(point));
  }
  Frame shading_frame(const SurfacePoint& point) const override {
    return nested_->shading_frame(point);
  }

 private:
  /// A direction outside and its refraction inside, both away from the nested surface.
  struct Crossing {
    Vec3 inside;
    float reflected;
  };

  Crossing enter(Vec3 w) const {
    const DielectricFresnel fresnel = fresnel_dielectric(std::abs(w.z), eta_);
    return {-refract(w, fresnel), fresnel.reflectance};
  }

  /// Empty at total internal reflection.
  std::optional<Vec3> leave(Vec3 inside) const {
    const DielectricFresnel fresnel = fresnel_dielectric(std::abs(inside.z), 1 / eta_);
    if (fresnel.reflectance == 1) return std::nullopt;
    return -refract(inside, fresnel);
  }

  /// Share of light that survives both crossings and the way between.
  Color attenuation(const SurfacePoint& point, const Crossing& out, const Crossing& in) const {
    const float path = 1 / std::abs(out.inside.z) + 1 / std::abs(in.inside.z);  // [thickness]
    return (1 - out.reflected) * (1 - in.reflected) * glm::exp(-path * absorption_.eval(point));
  }

  /// dω inside / dω outside.
  float solid_angle_ratio(Vec3 outside, const Crossing& crossing) const {
    return outside.z / (crossing.inside.z * eta_ * eta_);
  }

  float specular_probability(float reflected) const {
    const float specular = reflected * specular_weight_;
    return specular / (specular + (1 - reflected) * (1 - specular_weight_));
  }

  std::optional<BsdfSample> mirror_sample(const SurfacePoint& point, Vec3 wo) const {
    const auto event = specular(point, wo, kLobeDeltaReflection);
    return BsdfSample{event->wi, event->value / event->probability, event->probability, 1.0f,
                      kLobeDeltaReflection};
  }

  float eta_;
  BsdfPointer nested_;
  ColorTexture absorption_;  // over one thickness, straight down
  ColorTexture specular_;
  float specular_weight_ = 0;
};

}  // namespace

BsdfPointer make_bsdf(const CoatingBsdf& description, const BsdfContext& context) {
  ColorInput absorption = description.sigma_a;
  absorption.value *= description.thickness;
  return std::make_shared<Coating>(context.relative_ior(description.int_ior, description.ext_ior),
                                   context.nested(description.nested), context.color(absorption),
                                   context.color(description.specular_reflectance));
}

}  // namespace guidelight

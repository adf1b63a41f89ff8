#include "renderer/scene/bsdf/factories.h"
#include "renderer/scene/bsdf/fresnel.h"

namespace guidelight {
namespace {

/// A pane: mirror and straight pass, with all reflections between its two faces summed.
class ThinDielectric final : public Bsdf {
 public:
  ThinDielectric(float eta, ColorTexture reflectance, ColorTexture transmittance)
      : eta_(eta), reflectance_(std::move(reflectance)), transmittance_(std::move(transmittance)) {}

  Color eval(const SurfacePoint&, Vec3, Vec3) const override { return Color(0.0f); }
  float pdf(const SurfacePoint&, Vec3, Vec3) const override { return 0; }

  std::optional<BsdfSample> sample(const SurfacePoint& point, Vec3 wo, float u_lobe,
                                   Vec2) const override {
    const float reflected = pane_reflectance(wo);
    if (u_lobe < reflected) {
      return BsdfSample{reflect(wo), reflectance_.eval(point), reflected, 1.0f,
                        kLobeDeltaReflection};
    }
    return BsdfSample{-wo, transmittance_.eval(point), 1 - reflected, 1.0f, kLobeDeltaTransmission};
  }

  std::optional<SpecularEvent> specular(const SurfacePoint& point, Vec3 wo,
                                        Lobe lobe) const override {
    const float reflected = pane_reflectance(wo);
    if (lobe == kLobeDeltaReflection && reflected > 0) {
      return SpecularEvent{reflect(wo), reflected * reflectance_.eval(point), reflected};
    }
    if (lobe == kLobeDeltaTransmission && reflected < 1) {
      return SpecularEvent{-wo, (1 - reflected) * transmittance_.eval(point), 1 - reflected};
    }
    return std::nullopt;
  }

  int lobes() const override { return kLobeDelta; }
  Color albedo(const SurfacePoint& point) const override {
    return glm::max(reflectance_.eval(point), transmittance_.eval(point));
  }

 private:
  /// R + T²R + T²R³ + … = 2R / (1 + R) for T = 1 - R.
  float pane_reflectance(Vec3 wo) const {
    const float face = fresnel_dielectric(std::abs(wo.z), eta_).reflectance;
    return 2 * face / (1 + face);
  }

  float eta_;
  ColorTexture reflectance_;
  ColorTexture transmittance_;
};

}  // namespace

BsdfPointer make_bsdf(const ThinDielectricBsdf& description, const BsdfContext& context) {
  return std::make_shared<ThinDielectric>(
      context.relative_ior(description.int_ior, description.ext_ior),
      context.color(description.specular_reflectance),
      context.color(description.specular_transmittance));
}

}  // namespace guidelight

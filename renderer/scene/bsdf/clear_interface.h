#pragma once

#include "renderer/scene/bsdf/factories.h"
#include "renderer/scene/bsdf/fresnel.h"

namespace guidelight {

/// A smooth interface that reflects a share of the light like a mirror and lets the rest through.
/// Derived classes say how much, and where the rest goes.
class ClearInterface : public Bsdf {
 public:
  ClearInterface(ColorTexture reflectance, ColorTexture transmittance)
      : reflectance_(std::move(reflectance)), transmittance_(std::move(transmittance)) {}

  BsdfEvaluation evaluate(const SurfacePoint&, Vec3, Vec3) const final { return {}; }

  std::optional<BsdfSample> sample(const SurfacePoint& point, Vec3 wo, float u_lobe,
                                   Vec2) const final {
    const Split light = split(wo);
    if (u_lobe < light.reflected) {
      return BsdfSample{reflect(wo), reflectance_.eval(point), light.reflected, 1.0f,
                        kLobeDeltaReflection};
    }
    return BsdfSample{light.transmitted, transmittance_.eval(point), 1 - light.reflected, light.eta,
                      kLobeDeltaTransmission};
  }

  std::optional<SpecularEvent> specular(const SurfacePoint& point, Vec3 wo, Lobe lobe) const final {
    const Split light = split(wo);
    const float reflected = light.reflected;
    if (lobe == kLobeDeltaReflection && reflected > 0) {
      return SpecularEvent{reflect(wo), reflected * reflectance_.eval(point), reflected};
    }
    if (lobe == kLobeDeltaTransmission && reflected < 1) {
      return SpecularEvent{light.transmitted, (1 - reflected) * transmittance_.eval(point),
                           1 - reflected, light.eta};
    }
    return std::nullopt;
  }

  int lobes() const final { return kLobeDelta; }
  Color albedo(const SurfacePoint& point) const final {
    return glm::max(reflectance_.eval(point), transmittance_.eval(point));
  }

 protected:
  struct Split {
    float reflected;   // share
    Vec3 transmitted;  // direction
    float eta = 1;     // IOR on its side over that on the side of wo
  };

 private:
  virtual Split split(Vec3 wo) const = 0;

  ColorTexture reflectance_;
  ColorTexture transmittance_;
};

}  // namespace guidelight

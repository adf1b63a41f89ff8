#include "renderer/scene/bsdf/clear_interface.h"

namespace guidelight {
namespace {

/// A pane: mirror and straight pass, with all reflections between its two faces summed.
class ThinDielectric final : public ClearInterface {
 public:
  ThinDielectric(float eta, ColorTexture reflectance, ColorTexture transmittance)
      : ClearInterface(std::move(reflectance), std::move(transmittance)), eta_(eta) {}

 private:
  Split split(Vec3 wo) const override {
    const float face = fresnel_dielectric(std::abs(wo.z), eta_).reflectance;
    return {2 * face / (1 + face), -wo};  // R + T²R + T²R³ + … for T = 1 - R
  }

  float eta_;
};

}  // namespace

BsdfPointer make_bsdf(const ThinDielectricBsdf& description, const BsdfContext& context) {
  return std::make_shared<ThinDielectric>(
      context.relative_ior(description.int_ior, description.ext_ior),
      context.color(description.specular_reflectance),
      context.color(description.specular_transmittance));
}

}  // namespace guidelight

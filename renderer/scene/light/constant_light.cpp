#include "renderer/scene/light/lights.h"
#include "renderer/scene/light/scene_disc.h"

namespace guidelight {

namespace {

/// The same radiance from all directions.
class ConstantLight final : public Light {
 public:
  ConstantLight(Color radiance, const LightContext& context)
      : radiance_(radiance), disc_(context) {}

  bool is_infinite() const override { return true; }
  Color radiance_from(Vec3) const override { return radiance_; }

  std::optional<DirectSample> sample_direct(Vec3, Vec2 u) const override {
    return distant_sample(square_to_sphere(u), radiance_, kUniformSpherePdf, disc_);
  }
  float pdf_direct_from(Vec3) const override { return kUniformSpherePdf; }

  std::optional<EmissionSample> sample_emission(Vec2 u_position, Vec2 u_direction) const override {
    return distant_emission(square_to_sphere(u_direction), radiance_, kUniformSpherePdf, disc_,
                            u_position);
  }
  EmissionPdf pdf_emission(const SurfacePoint&, Vec3) const override {
    return {disc_.pdf(), kUniformSpherePdf};
  }

  float power() const override { return 4 * kPi * disc_.area() * luminance(radiance_); }

 private:
  Color radiance_;
  SceneDisc disc_;
};

}  // namespace

std::unique_ptr<Light> make_constant_light(const ConstantEmitter& emitter,
                                           const LightContext& context) {
  return std::make_unique<ConstantLight>(emitter.radiance, context);
}

}  // namespace guidelight

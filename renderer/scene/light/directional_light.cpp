#include "renderer/error.h"
#include "renderer/scene/light/lights.h"
#include "renderer/scene/light/scene_disc.h"

namespace guidelight {

namespace {

/// Parallel light from infinity.
class DirectionalLight final : public Light {
 public:
  DirectionalLight(Vec3 direction, Color irradiance, const LightContext& context)
      : towards_(-direction), irradiance_(irradiance), disc_(context) {}

  bool is_delta_direction() const override { return true; }
  bool is_infinite() const override { return true; }

  std::optional<DirectSample> sample_direct(Vec3, Vec2) const override {
    return distant_sample(towards_, irradiance_, 1, disc_);
  }

  std::optional<EmissionSample> sample_emission(Vec2 u_position, Vec2) const override {
    return distant_emission(towards_, irradiance_, 1, disc_, u_position);
  }

  EmissionPdf pdf_emission(const SurfacePoint&, Vec3) const override { return {disc_.pdf(), 0}; }

  float power() const override { return disc_.area() * luminance(irradiance_); }

 private:
  Vec3 towards_;
  Color irradiance_;
  SceneDisc disc_;
};

}  // namespace

std::unique_ptr<Light> make_directional_light(const DirectionalEmitter& emitter,
                                              const LightContext& context) {
  const float length = glm::length(emitter.direction);
  if (!(length > 0) || !std::isfinite(length)) {
    throw Error("the direction has no length; give it one");
  }
  return std::make_unique<DirectionalLight>(emitter.direction / length, emitter.irradiance,
                                            context);
}

}  // namespace guidelight

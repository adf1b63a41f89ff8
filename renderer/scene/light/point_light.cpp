#include "renderer/sampling/warp.h"
#include "renderer/scene/light/delta_position.h"
#include "renderer/scene/light/lights.h"

namespace guidelight {

namespace {

/// The same intensity in all directions, from a point.
class PointLight final : public Light {
 public:
  explicit PointLight(const PointEmitter& emitter)
      : position_(emitter.position), intensity_(emitter.intensity) {}

  bool is_delta_position() const override { return true; }

  std::optional<DirectSample> sample_direct(Vec3 reference, Vec2) const override {
    const Vec3 to_light = position_ - reference;
    const float distance = glm::length(to_light);
    if (!(distance > 0)) return std::nullopt;
    return point_sample(position_, to_light / distance, distance, intensity_, kUniformSpherePdf);
  }

  std::optional<EmissionSample> sample_emission(Vec2, Vec2 u_direction) const override {
    return point_emission(position_, square_to_sphere(u_direction), intensity_, kUniformSpherePdf);
  }

  EmissionPdf pdf_emission(const SurfacePoint&, Vec3) const override {
    return {0, kUniformSpherePdf};
  }

  float power() const override { return 4 * kPi * luminance(intensity_); }

 private:
  Vec3 position_;
  Color intensity_;
};

}  // namespace

std::unique_ptr<Light> make_point_light(const PointEmitter& emitter) {
  return std::make_unique<PointLight>(emitter);
}

}  // namespace guidelight

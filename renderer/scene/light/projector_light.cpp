#include "renderer/error.h"
#include "renderer/math/axes.h"
#include "renderer/scene/light/delta_position.h"
#include "renderer/scene/light/lights.h"
#include "renderer/scene/light/radiance_map.h"

namespace guidelight {

namespace {

float same_for_all_rows(int, int) { return 1; }

/// A pinhole that throws an image.
class ProjectorLight final : public Light {
 public:
  explicit ProjectorLight(const ProjectorEmitter& emitter)
      : position_(emitter.to_world[3]),
        map_(emitter.image, RadianceMap::Wrap::Clamp, same_for_all_rows),
        scale_(kPi * emitter.scale) {
    const auto axes = orthonormal_axes(emitter.to_world);
    if (!axes)
      throw Error("the transform is singular or not finite; give it one that can be inverted");
    axes_ = *axes;
    if (!(emitter.fov_x > 0 && emitter.fov_x < kPi)) {
      throw Error("the field of view is {} rad; give an angle between 0 and π", emitter.fov_x);
    }
    const float half_width = std::tan(0.5f * emitter.fov_x);
    half_size_ = {half_width, half_width / map_.aspect()};
    screen_area_ = 4 * half_size_.x * half_size_.y;
  }

  bool is_delta_position() const override { return true; }

  std::optional<DirectSample> sample_direct(Vec3 reference, Vec2) const override {
    const Vec3 to_light = position_ - reference;
    const float distance = glm::length(to_light);
    const Vec3 wi = to_light / distance;
    const Vec3 local = -wi * axes_;
    const auto uv = on_image(local);
    if (!uv) return std::nullopt;
    return point_sample(position_, wi, distance, intensity(*uv, local.z),
                        pdf_direction(*uv, local.z));
  }

  std::optional<EmissionSample> sample_emission(Vec2, Vec2 u_direction) const override {
    const Vec2 uv = map_.sample(u_direction).position;
    const Vec3 local = glm::normalize(Vec3(half_size_ * (1.0f - 2.0f * uv), 1));
    return point_emission(position_, axes_ * local, intensity(uv, local.z),
                          pdf_direction(uv, local.z));
  }

  EmissionPdf pdf_emission(const SurfacePoint&, Vec3 w) const override {
    const Vec3 local = w * axes_;
    const auto uv = on_image(local);
    return {0, uv ? pdf_direction(*uv, local.z) : 0.0f};
  }

  float power() const override { return scale_ * screen_area_ * luminance(map_.mean()); }

 private:
  std::optional<Vec2> on_image(Vec3 local) const {
    if (!(local.z > 0)) return std::nullopt;
    const Vec2 uv = 0.5f - 0.5f * Vec2(local) / (local.z * half_size_);
    const bool inside = uv.x >= 0 && uv.y >= 0 && uv.x < 1 && uv.y < 1;
    return inside ? std::optional(uv) : std::nullopt;
  }

  /// Irradiance E on the screen at z = 1 means intensity E/cos³θ.
  Color intensity(Vec2 uv, float cosine) const {
    return map_.eval(uv) * (scale_ / (cosine * cosine * cosine));
  }
  float pdf_direction(Vec2 uv, float cosine) const {
    return map_.pdf(uv) / (screen_area_ * cosine * cosine * cosine);
  }

  Vec3 position_;
  Mat3 axes_;
  RadianceMap map_;
  float scale_;
  Vec2 half_size_;  // of the screen at z = 1
  float screen_area_;
};

}  // namespace

std::unique_ptr<Light> make_projector_light(const ProjectorEmitter& emitter) {
  return std::make_unique<ProjectorLight>(emitter);
}

}  // namespace guidelight

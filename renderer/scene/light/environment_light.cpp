#include "renderer/error.h"
#include "renderer/math/axes.h"
#include "renderer/scene/light/lights.h"
#include "renderer/scene/light/radiance_map.h"
#include "renderer/scene/light/scene_disc.h"

namespace guidelight {

namespace {

/// Solid angle of a row of a latitude-longitude image, up to a constant.
float row_solid_angle(int y, int height) {
  return std::sin((static_cast<float>(y) + 0.5f) * kPi / static_cast<float>(height));
}

/// Radiance from all directions after a latitude-longitude image, importance sampled.
class EnvironmentLight final : public Light {
 public:
  EnvironmentLight(const EnvironmentEmitter& emitter, const LightContext& context)
      : map_(emitter.image, RadianceMap::Wrap::Repeat, row_solid_angle),
        scale_(emitter.scale),
        disc_(context) {
    const auto axes = orthonormal_axes(emitter.to_world);
    if (!axes)
      throw Error("the transform is singular or not finite; give it one that can be inverted");
    axes_ = *axes;
  }

  bool is_infinite() const override { return true; }
  Color radiance_from(Vec3 towards) const override {
    return scale_ * map_.eval(to_image(towards * axes_));
  }

  std::optional<DirectSample> sample_direct(Vec3, Vec2 u) const override {
    const Direction direction = sample_direction(u);
    if (!(direction.pdf > 0)) return std::nullopt;
    return distant_sample(direction.towards, direction.radiance, direction.pdf, disc_);
  }

  float pdf_direct_from(Vec3 towards) const override {
    const Vec3 local = towards * axes_;
    const float sin_theta = std::sqrt(sqr(local.x) + sqr(local.z));
    return sin_theta > 0 ? map_.pdf(to_image(local)) / (2 * kPi * kPi * sin_theta) : 0.0f;
  }

  std::optional<EmissionSample> sample_emission(Vec2 u_position, Vec2 u_direction) const override {
    const Direction direction = sample_direction(u_direction);
    if (!(direction.pdf > 0)) return std::nullopt;
    return distant_emission(direction.towards, direction.radiance, direction.pdf, disc_,
                            u_position);
  }

  EmissionPdf pdf_emission(const SurfacePoint&, Vec3 w) const override {
    return {disc_.pdf(), pdf_direct_from(-w)};
  }

  float power() const override { return 4 * kPi * disc_.area() * scale_ * luminance(map_.mean()); }

 private:
  struct Direction {
    Vec3 towards;
    Color radiance;
    float pdf;  // per solid angle
  };

  Direction sample_direction(Vec2 u) const {
    const GridDistribution::Sample sample = map_.sample(u);
    const float theta = kPi * sample.position.y;
    const float phi = 2 * kPi * sample.position.x;
    const float sin_theta = std::sin(theta);
    const Vec3 local(sin_theta * std::sin(phi), std::cos(theta), -sin_theta * std::cos(phi));
    const float pdf = sin_theta > 0 ? sample.pdf / (2 * kPi * kPi * sin_theta) : 0.0f;
    return {axes_ * local, scale_ * map_.eval(sample.position), pdf};
  }

  static Vec2 to_image(Vec3 local) {
    const float u = std::atan2(local.x, -local.z) * (0.5f * kInvPi);
    // The angle from the pole by atan2: acos would lose the digits near the poles.
    const float v = std::atan2(std::sqrt(sqr(local.x) + sqr(local.z)), local.y) * kInvPi;
    return {u < 0 ? u + 1 : u, v};
  }

  RadianceMap map_;
  float scale_;
  Mat3 axes_;
  SceneDisc disc_;
};

}  // namespace

std::unique_ptr<Light> make_environment_light(const EnvironmentEmitter& emitter,
                                              const LightContext& context) {
  return std::make_unique<EnvironmentLight>(emitter, context);
}

}  // namespace guidelight

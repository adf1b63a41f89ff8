#include "renderer/scene/light/lights.h"
#include "renderer/scene/light/scene_disc.h"

namespace guidelight {

namespace {

/// A disc in the sky of constant radiance: the sun.
class DistantDiscLight final : public Light {
 public:
  DistantDiscLight(Vec3 towards, float angular_radius, Color radiance, const LightContext& context)
      : frame_(Frame::from_normal(towards)),
        one_minus_cos_max_(2 * sqr(std::sin(0.5f * angular_radius))),
        radiance_(radiance),
        disc_(context) {}

  bool is_infinite() const override { return true; }
  Color radiance_from(Vec3 towards) const override {
    return contains(towards) ? radiance_ : Color(0);
  }

  std::optional<DirectSample> sample_direct(Vec3, Vec2 u) const override {
    return distant_sample(sample_direction(u), radiance_, pdf(), disc_);
  }
  float pdf_direct_from(Vec3 towards) const override { return contains(towards) ? pdf() : 0.0f; }

  std::optional<EmissionSample> sample_emission(Vec2 u_position, Vec2 u_direction) const override {
    return distant_emission(sample_direction(u_direction), radiance_, pdf(), disc_, u_position);
  }
  EmissionPdf pdf_emission(const SurfacePoint&, Vec3 w) const override {
    return {disc_.pdf(), pdf_direct_from(-w)};
  }

  float power() const override { return luminance(radiance_) * disc_.area() / pdf(); }

 private:
  Vec3 sample_direction(Vec2 u) const {
    return frame_.to_world(square_to_narrow_cap(u, one_minus_cos_max_));
  }
  float pdf() const { return narrow_cap_pdf(one_minus_cos_max_); }
  bool contains(Vec3 w) const {
    // |w - n|² = 2 (1 - cos θ), without the cancellation.
    return length_squared(w - frame_.n) <= 2 * one_minus_cos_max_;
  }

  Frame frame_;
  float one_minus_cos_max_;
  Color radiance_;
  SceneDisc disc_;
};

}  // namespace

std::unique_ptr<Light> make_distant_disc_light(Vec3 towards, float angular_radius, Color radiance,
                                               const LightContext& context) {
  return std::make_unique<DistantDiscLight>(towards, angular_radius, radiance, context);
}

}  // namespace guidelight

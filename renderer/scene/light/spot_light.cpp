#include <algorithm>

#include "renderer/error.h"
#include "renderer/math/axes.h"
#include "renderer/sampling/warp.h"
#include "renderer/scene/light/delta_position.h"
#include "renderer/scene/light/lights.h"

namespace guidelight {

namespace {

/// A point light within a cone, with the linear fall-off in angle that Mitsuba's scenes expect. The
/// texture covers the square around the cone's base.
class SpotLight final : public Light {
 public:
  SpotLight(const SpotEmitter& emitter, const LightContext& context)
      : position_(emitter.to_world[3]), intensity_(emitter.intensity) {
    const auto axes = orthonormal_axes(emitter.to_world);
    if (!axes)
      throw Error("the transform is singular or not finite; give it one that can be inverted");
    axes_ = *axes;
    cutoff_ = std::clamp(emitter.cutoff_angle, 1e-4f, kPi);
    beam_ = std::clamp(emitter.beam_width, 0.0f, cutoff_);
    const float sin_half_cutoff = std::sin(0.5f * cutoff_);
    one_minus_cos_cutoff_ = 2 * sqr(sin_half_cutoff);
    one_minus_cos_beam_ = 2 * sqr(std::sin(0.5f * beam_));
    inverse_transition_ = beam_ < cutoff_ ? 1 / (cutoff_ - beam_) : 0.0f;
    if (emitter.texture != kNone && context.textures) {
      texture_ = context.textures->at(emitter.texture);
      inverse_tan_cutoff_ = 1 / std::tan(std::min(cutoff_, 0.499f * kPi));
    }
  }

  bool is_delta_position() const override { return true; }

  std::optional<DirectSample> sample_direct(Vec3 reference, Vec2) const override {
    const Vec3 to_light = position_ - reference;
    const float distance = glm::length(to_light);
    if (!(distance > 0)) return std::nullopt;
    const Vec3 wi = to_light / distance;
    const Color intensity = intensity_towards(-wi * axes_);
    if (is_black(intensity)) return std::nullopt;
    return point_sample(position_, wi, distance, intensity, narrow_cap_pdf(one_minus_cos_cutoff_));
  }

  std::optional<EmissionSample> sample_emission(Vec2, Vec2 u_direction) const override {
    const Vec3 local = square_to_narrow_cap(u_direction, one_minus_cos_cutoff_);
    return point_emission(position_, axes_ * local, intensity_towards(local),
                          narrow_cap_pdf(one_minus_cos_cutoff_));
  }

  EmissionPdf pdf_emission(const SurfacePoint&, Vec3 w) const override {
    const bool inside = 1 - glm::dot(axes_[2], w) <= one_minus_cos_cutoff_;
    return {0, inside ? narrow_cap_pdf(one_minus_cos_cutoff_) : 0.0f};
  }

  float power() const override {
    // ∫ falloff dω = 2π (1 - (sin c - sin b)/(c - b)) for cutoff c and beam b.
    const float mean_cosine = beam_ < cutoff_
                                  ? (std::sin(cutoff_) - std::sin(beam_)) * inverse_transition_
                                  : std::cos(cutoff_);
    const Color mean = texture_ ? texture_->mean() : Color(1);
    return 2 * kPi * (1 - mean_cosine) * luminance(intensity_ * mean);
  }

 private:
  Color intensity_towards(Vec3 local) const {
    const float one_minus_cos = 1 - local.z;
    if (one_minus_cos >= one_minus_cos_cutoff_) return Color(0);
    Color intensity = intensity_;
    if (one_minus_cos > one_minus_cos_beam_) {
      intensity *= std::max(0.0f, (cutoff_ - std::acos(local.z)) * inverse_transition_);
    }
    return texture_ ? intensity * texture_towards(local) : intensity;
  }

  Color texture_towards(Vec3 local) const {
    if (local.z <= 0) return Color(0);
    SurfacePoint point;
    point.uv = 0.5f + 0.5f * inverse_tan_cutoff_ / local.z * Vec2(local);
    return texture_->eval(point);
  }

  Vec3 position_;
  Mat3 axes_;
  Color intensity_;
  float cutoff_;
  float beam_;
  float one_minus_cos_cutoff_;
  float one_minus_cos_beam_;
  float inverse_transition_;
  float inverse_tan_cutoff_ = 0;
  std::shared_ptr<const Texture> texture_;
};

}  // namespace

std::unique_ptr<Light> make_spot_light(const SpotEmitter& emitter, const LightContext& context) {
  return std::make_unique<SpotLight>(emitter, context);
}

}  // namespace guidelight

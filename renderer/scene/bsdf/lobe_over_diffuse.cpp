#include "renderer/scene/bsdf/lobe_over_diffuse.h"

#include "renderer/sampling/warp.h"

namespace guidelight {

namespace {

/// Lobes that add up are dimmed where they would reflect more than they receive; by as much as
/// Mitsuba dims them, so that its scenes look the same.
float energy_scale(const ColorTexture& diffuse, const ColorTexture& specular) {
  const float sum = max_component(diffuse.mean() + specular.mean());
  return sum > 1 ? 0.99f / sum : 1.0f;
}

}  // namespace

LobeOverDiffuse::LobeOverDiffuse(ColorTexture diffuse, ColorTexture specular)
    : specular_probability_(specular_sampling_weight(diffuse, specular)),
      scale_(energy_scale(diffuse, specular)),
      diffuse_(std::move(diffuse)),
      specular_(std::move(specular)) {}

BsdfEvaluation LobeOverDiffuse::evaluate(const SurfacePoint& point, Vec3 wo, Vec3 wi) const {
  if (wo.z <= 0 || wi.z <= 0) return {};
  const SymmetricLobe lobe = evaluate_lobe(point, wo, wi);
  const Color f = diffuse_.eval(point) * kInvPi + specular_.eval(point) * lobe.f;
  return {f * (scale_ * wi.z), glm::mix(wi.z * kInvPi, lobe.pdf, specular_probability_),
          glm::mix(wo.z * kInvPi, lobe.pdf, specular_probability_)};
}

std::optional<BsdfSample> LobeOverDiffuse::sample(const SurfacePoint& point, Vec3 wo, float u_lobe,
                                                  Vec2 u) const {
  if (wo.z <= 0) return std::nullopt;
  const bool is_specular = u_lobe < specular_probability_;
  const Vec3 wi = is_specular ? sample_lobe(point, wo, u) : square_to_cosine_hemisphere(u);
  return sample_of_all_lobes(*this, point, wo, wi, is_specular ? kLobeGlossy : kLobeDiffuse);
}

Color LobeOverDiffuse::albedo(const SurfacePoint& point) const {
  return scale_ * (diffuse_.eval(point) + specular_.eval(point));
}

}  // namespace guidelight

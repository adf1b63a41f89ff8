#pragma once

#include "renderer/math/frame.h"
#include "renderer/scene/description.h"
#include "renderer/scene/texture.h"

namespace guidelight {

/// Roughness below which a surface counts as perfectly smooth: its lobe would be narrower than
/// 0.06° and the density of a half vector would exceed what single precision can resolve.
inline constexpr float kMinAlpha = 5e-4f;

/// True if a roughness is so small everywhere. Roughness from a texture is clamped instead.
inline bool is_smooth(const FloatTexture& alpha) {
  return alpha.is_constant() && alpha.mean() < kMinAlpha;
}

/// What perfectly mirroring facets do between two directions on their outside.
struct FacetReflection {
  float value;        // f(wo, wi)·|cosθ_i|
  float pdf;          // of wi by reflection at a visible normal, per solid angle
  float pdf_reverse;  // of wo, if the path came from wi
};

/// Distribution of microfacet normals with Smith's masking, separable in the two directions as in
/// Walter et al. 2007, "Microfacet Models for Refraction through Rough Surfaces" (equation numbers
/// below), stretched to two roughnesses. All directions are local; normals m have m.z > 0.
class MicrofacetDistribution {
 public:
  /// Roughness is clamped to kMinAlpha.
  MicrofacetDistribution(Microfacet kind, float alpha_u, float alpha_v)
      : kind_(kind),
        alpha_u_(std::max(alpha_u, kMinAlpha)),
        alpha_v_(std::max(alpha_v, kMinAlpha)) {}

  /// Facet area per solid angle of m and unit of macrosurface; ∫ D(m) m.z dm = 1.
  float density(Vec3 m) const;

  /// Share of the facets with normal m that is visible from w; zero for facets seen from behind.
  float masking(Vec3 w, Vec3 m) const { return glm::dot(w, m) * w.z > 0 ? masking(w) : 0.0f; }

  /// `m` is halfway between the directions, wo.z > 0 and wi.z > 0.
  FacetReflection reflection(Vec3 wo, Vec3 wi, Vec3 m) const {
    const float quarter_density = 0.25f * density(m);
    const float visible_i = masking(wi, m);
    const float pdf = masking(wo, m) * quarter_density / wo.z;          // (14)
    return {pdf * visible_i, pdf, visible_i * quarter_density / wi.z};  // value: (20)
  }

  /// Draws a normal among those visible from w, w.z > 0.
  Vec3 sample_visible(Vec3 w, Vec2 u) const;
  /// Density of sample_visible, per solid angle of m.
  float pdf_visible(Vec3 w, Vec3 m) const {
    const float cos_wm = glm::dot(w, m);
    return cos_wm > 0 && w.z > 0 ? masking(w) * cos_wm * density(m) / w.z : 0.0f;
  }

 private:
  float masking(Vec3 w) const;

  Microfacet kind_;
  float alpha_u_;
  float alpha_v_;
};

}  // namespace guidelight

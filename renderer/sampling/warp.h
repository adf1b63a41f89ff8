#pragma once

#include "renderer/math/vector.h"

/// Maps from the unit square to the sets that light transport samples; each with its density.
namespace guidelight {

/// Uniform on the unit disk, area preserving and continuous (Shirley & Chiu 1997).
Vec2 square_to_disk(Vec2 u);
inline constexpr float kUniformDiskPdf = kInvPi;  // per unit area

/// Cosine-weighted on the hemisphere z > 0; pdf per solid angle.
Vec3 square_to_cosine_hemisphere(Vec2 u);
inline float cosine_hemisphere_pdf(float cos_theta) {
  return cos_theta > 0 ? cos_theta * kInvPi : 0.0f;
}

/// Uniform on the unit sphere; pdf per solid angle.
Vec3 square_to_sphere(Vec2 u);
inline constexpr float kUniformSpherePdf = 0.25f * kInvPi;

/// Uniform on the spherical cap around +z with cosθ ≥ cos_max; pdf per solid angle.
Vec3 square_to_cap(Vec2 u, float cos_max);
float uniform_cap_pdf(float cos_max);
/// The same with the cap given by 1-cosθ, for caps so narrow that their cosine rounds to 1.
Vec3 square_to_narrow_cap(Vec2 u, float one_minus_cos_max);
inline float narrow_cap_pdf(float one_minus_cos_max) { return 0.5f * kInvPi / one_minus_cos_max; }

/// Uniform barycentric coordinates (b1, b2) on a triangle; pdf 1/area.
Vec2 square_to_triangle(Vec2 u);

}  // namespace guidelight

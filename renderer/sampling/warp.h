#pragma once

#include "renderer/math/vector.h"

/// Maps from the unit square to the sets that light transport samples; each with its density.
namespace guidelight {

/// Uniform on the unit disk, area preserving and continuous (Shirley & Chiu 1997).
inline Vec2 square_to_disk(Vec2 u) {
  const Vec2 p = 2.0f * u - 1.0f;
  if (p.x == 0 && p.y == 0) return {0, 0};
  const bool wide = std::abs(p.x) > std::abs(p.y);
  const float radius = wide ? p.x : p.y;
  const float angle = wide ? kPi / 4 * (p.y / p.x) : kPi / 2 - kPi / 4 * (p.x / p.y);
  return radius * Vec2(std::cos(angle), std::sin(angle));
}
inline constexpr float kUniformDiskPdf = kInvPi;  // per unit area

/// Cosine-weighted on the hemisphere z > 0; pdf per solid angle.
inline Vec3 square_to_cosine_hemisphere(Vec2 u) {
  const Vec2 d = square_to_disk(u);
  return {d.x, d.y, safe_sqrt(1 - d.x * d.x - d.y * d.y)};
}
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
inline Vec2 square_to_triangle(Vec2 u) {
  const float root = std::sqrt(u.x);
  return {root * (1 - u.y), root * u.y};
}

}  // namespace guidelight

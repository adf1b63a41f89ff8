#include "renderer/sampling/warp.h"

namespace guidelight {

Vec3 square_to_sphere(Vec2 u) { return square_to_cap(u, -1.0f); }

Vec3 square_to_cap(Vec2 u, float cos_max) { return square_to_narrow_cap(u, 1 - cos_max); }

Vec3 square_to_narrow_cap(Vec2 u, float one_minus_cos_max) {
  const float one_minus_cos = u.x * one_minus_cos_max;
  const float sin_theta = safe_sqrt(one_minus_cos * (2 - one_minus_cos));
  const float phi = 2 * kPi * u.y;
  return {sin_theta * std::cos(phi), sin_theta * std::sin(phi), 1 - one_minus_cos};
}

float uniform_cap_pdf(float cos_max) { return narrow_cap_pdf(1 - cos_max); }

}  // namespace guidelight

#include "renderer/sampling/warp.h"

namespace guidelight {

Vec2 square_to_disk(Vec2 u) {
  const Vec2 p = 2.0f * u - 1.0f;
  if (p.x == 0 && p.y == 0) return {0, 0};
  const bool wide = std::abs(p.x) > std::abs(p.y);
  const float radius = wide ? p.x : p.y;
  const float angle = wide ? kPi / 4 * (p.y / p.x) : kPi / 2 - kPi / 4 * (p.x / p.y);
  return radius * Vec2(std::cos(angle), std::sin(angle));
}

Vec3 square_to_cosine_hemisphere(Vec2 u) {
  const Vec2 d = square_to_disk(u);
  return {d.x, d.y, safe_sqrt(1 - d.x * d.x - d.y * d.y)};
}

Vec3 square_to_sphere(Vec2 u) { return square_to_cap(u, -1.0f); }

Vec3 square_to_cap(Vec2 u, float cos_max) { return square_to_narrow_cap(u, 1 - cos_max); }

Vec3 square_to_narrow_cap(Vec2 u, float one_minus_cos_max) {
  const float one_minus_cos = u.x * one_minus_cos_max;
  const float sin_theta = safe_sqrt(one_minus_cos * (2 - one_minus_cos));
  const float phi = 2 * kPi * u.y;
  return {sin_theta * std::cos(phi), sin_theta * std::sin(phi), 1 - one_minus_cos};
}

float uniform_cap_pdf(float cos_max) { return narrow_cap_pdf(1 - cos_max); }

Vec2 square_to_triangle(Vec2 u) {
  const float root = std::sqrt(u.x);
  return {root * (1 - u.y), root * u.y};
}

}  // namespace guidelight

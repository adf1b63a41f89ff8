#pragma once

#include "renderer/math/vector.h"

namespace guidelight {

/// Right-handed orthonormal basis; local z is `n`.
struct Frame {
  Vec3 s{1, 0, 0};
  Vec3 t{0, 1, 0};
  Vec3 n{0, 0, 1};

  Frame() = default;
  Frame(Vec3 s_axis, Vec3 t_axis, Vec3 n_axis) : s(s_axis), t(t_axis), n(n_axis) {}

  /// Any basis around a unit normal (Duff et al. 2017, "Building an Orthonormal Basis, Revisited").
  static Frame from_normal(Vec3 normal) {
    const float sign = std::copysign(1.0f, normal.z);
    const float a = -1.0f / (sign + normal.z);
    const float b = normal.x * normal.y * a;
    return {Vec3(1 + sign * sqr(normal.x) * a, sign * b, -sign * normal.x),
            Vec3(b, sign + sqr(normal.y) * a, -normal.y), normal};
  }

  /// Basis around a unit normal whose `s` lies in the plane of `tangent` and the normal. Falls back
  /// to any basis where the tangent is degenerate or parallel to the normal.
  static Frame from_normal_and_tangent(Vec3 normal, Vec3 tangent) {
    const Vec3 projected = tangent - normal * glm::dot(normal, tangent);
    const float squared = length_squared(projected);
    if (!(squared > 1e-12f * length_squared(tangent)) || !std::isfinite(squared)) {
      return from_normal(normal);
    }
    const Vec3 s_axis = projected / std::sqrt(squared);
    return {s_axis, glm::cross(normal, s_axis), normal};
  }

  Vec3 to_local(Vec3 v) const { return {glm::dot(v, s), glm::dot(v, t), glm::dot(v, n)}; }
  Vec3 to_world(Vec3 v) const { return s * v.x + t * v.y + n * v.z; }
};

/// Trigonometry of directions in a local frame.
inline float cos_theta(Vec3 w) { return w.z; }
inline float abs_cos_theta(Vec3 w) { return std::abs(w.z); }
inline float cos2_theta(Vec3 w) { return w.z * w.z; }
inline float sin2_theta(Vec3 w) { return std::max(0.0f, 1 - cos2_theta(w)); }
inline bool same_hemisphere(Vec3 a, Vec3 b) { return a.z * b.z > 0; }

}  // namespace guidelight

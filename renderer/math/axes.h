#pragma once

#include <optional>

#include "renderer/math/vector.h"

namespace guidelight {

/// The directions that a transform gives to local x, y and z, as unit columns at right angles. z is
/// kept exactly and y within the plane of y and z; shear, which no scene file means, is dropped.
/// Mirrored transforms give left-handed axes. Empty if the transform is singular or not finite.
inline std::optional<Mat3> orthonormal_axes(const Mat4& to_world) {
  const Mat3 linear(to_world);
  const double volume =
      static_cast<double>(glm::length(linear[0])) * glm::length(linear[1]) * glm::length(linear[2]);
  const double determinant = glm::determinant(glm::dmat3(linear));
  if (!std::isfinite(volume) || !is_finite(Vec3(to_world[3])) ||
      !(std::abs(determinant) > 1e-8 * volume)) {
    return std::nullopt;
  }
  const Vec3 z = glm::normalize(linear[2]);
  const Vec3 y = glm::normalize(linear[1] - z * glm::dot(z, linear[1]));
  const Vec3 x = glm::cross(y, z) * (determinant < 0 ? -1.0f : 1.0f);
  return Mat3(x, y, z);
}

}  // namespace guidelight

#pragma once

#include "renderer/scene/description.h"

namespace guidelight {

/// How an error message names a shape.
std::string shape_label(const ShapeDescription& description);

/// True if a transform takes some volume to none, relative to the lengths of its axes, so that
/// small and very flat shapes are welcome; false for one that is not finite.
bool is_singular(const Mat4& to_world);

/// The linear part of a shape's transform and its inverse. Points are best taken relative to the
/// origin of the shape before the inverse is applied: a small shape far from the world's origin
/// keeps its digits.
struct LinearTransform {
  Mat3 matrix;
  Mat3 inverse;
  float determinant;

  /// Throws Error if the transform is singular or not finite.
  LinearTransform(const Mat4& to_world, const ShapeDescription& description);

  /// Normals transform by the inverse transpose; the result is not normalised.
  Vec3 normal(Vec3 n) const { return n * inverse; }
};

/// Derivative of v/|v| where that of v is `change`.
inline Vec3 derivative_of_unit(Vec3 v, Vec3 change) {
  const float squared = glm::dot(v, v);
  return (change - v * (glm::dot(v, change) / squared)) / std::sqrt(squared);
}

}  // namespace guidelight

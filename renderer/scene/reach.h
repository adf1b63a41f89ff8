#pragma once

#include "renderer/math/vector.h"

namespace guidelight {

/// Coordinates of a scene beyond this overflow in squares of cross products.
inline constexpr float kLargestCoordinate = 1e9f;

/// Origins and directions of rays beyond this come from no scene: such rays meet nothing.
inline constexpr float kLargestRay = 10 * kLargestCoordinate;

/// False also for what is not finite.
inline bool is_within(Vec3 v, float limit) {
  return std::abs(v.x) <= limit && std::abs(v.y) <= limit && std::abs(v.z) <= limit;
}

}  // namespace guidelight

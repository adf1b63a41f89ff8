#pragma once

#include <cmath>

#include "renderer/math/vector.h"

namespace guidelight {

/// Homogeneous absorbing medium.
struct Medium {
  Color sigma_a{0.0f};  // [1 / scene unit]

  /// Over a distance that may be infinite: a channel that nothing absorbs passes all the same.
  Color transmittance(float distance) const {
    const auto channel = [&](float sigma) {
      return sigma > 0 ? std::exp(-sigma * distance) : 1.0f;
    };
    return {channel(sigma_a.x), channel(sigma_a.y), channel(sigma_a.z)};
  }
};

}  // namespace guidelight

#pragma once

#include "renderer/math/vector.h"

namespace guidelight {

/// Homogeneous absorbing medium.
struct Medium {
  Color sigma_a{0.0f};  // [1 / scene unit]

  Color transmittance(float distance) const { return glm::exp(-sigma_a * distance); }
};

}  // namespace guidelight

#pragma once

#include "renderer/math/vector.h"

namespace guidelight {

/// How photons count within the disc of an estimate.
enum class Kernel { Constant, Cone, Epanechnikov };

/// Value of a kernel at a squared distance from the centre of a disc, per area, 0 on its rim and
/// beyond. Its integral over the disc is 1: with t = d/r and the area element 2πr²t dt,
///   constant       ∫ 2t dt          = 1    so the factor is 1,
///   cone           ∫ (1-t) 2t dt    = 1/3  so it is 3,
///   Epanechnikov   ∫ (1-t²) 2t dt   = 1/2  so it is 2, each over πr².
///
/// The same holds when the disc reaches exactly to the k-th nearest photon. That one lies on the
/// rim and counts for nothing. Given r, the k-1 others are spread over the disc like any, so the
/// kernel's form does not change the mean, (k-1)/(πr²) per unit of power; and for photons of
/// density λ, πr²λ is Gamma distributed with shape k, whose reciprocal has the mean 1/(k-1). The
/// estimate is unbiased where λ is uniform; counting all k would make it too large by 1/(k-1).
inline float kernel_value(Kernel kernel, float distance_squared, float radius_squared) {
  if (distance_squared >= radius_squared) return 0;
  const float per_area = kInvPi / radius_squared;
  const float t_squared = distance_squared / radius_squared;
  switch (kernel) {
    case Kernel::Constant:
      return per_area;
    case Kernel::Cone:
      return 3 * (1 - std::sqrt(t_squared)) * per_area;
    case Kernel::Epanechnikov:
      return 2 * (1 - t_squared) * per_area;
  }
  return 0;
}

/// Whether a photon on a surface of one normal may be used on a surface of another: they differ by
/// less than 45°, which keeps light from leaking around corners.
inline bool is_same_side(Vec3 normal_a, Vec3 normal_b) {
  return glm::dot(normal_a, normal_b) > 0.7071f;
}
/// The same where a BSDF tells sides apart by itself, and may transmit.
inline bool is_same_surface(Vec3 normal_a, Vec3 normal_b) {
  return std::abs(glm::dot(normal_a, normal_b)) > 0.7071f;
}

}  // namespace guidelight

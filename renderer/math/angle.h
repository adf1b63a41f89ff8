#pragma once

#include <utility>

#include "renderer/math/vector.h"

namespace guidelight {

/// atan2 to 6e-7 rad, several times faster: texture coordinates of round shapes need it at every
/// hit. Abramowitz & Stegun, Handbook of Mathematical Functions, 4.4.49. Zero for (0, 0).
inline float fast_atan2(float y, float x) {
  float smaller = std::abs(x);
  float larger = std::abs(y);
  const bool is_steep = larger > smaller;
  if (!is_steep) std::swap(smaller, larger);
  const float t = larger > 0 ? smaller / larger : 0.0f;
  const float s = t * t;
  float angle = 0.0028662257f;
  for (const float c : {-0.0161657367f, 0.0429096138f, -0.0752896400f, 0.1065626393f,
                        -0.1420889944f, 0.1999355085f, -0.3333314528f, 1.0f}) {
    angle = angle * s + c;
  }
  angle *= t;
  if (is_steep) angle = 0.5f * kPi - angle;
  if (x < 0) angle = kPi - angle;
  return std::copysign(angle, y);
}

}  // namespace guidelight

#pragma once

#include <bit>
#include <cstdint>

#include "renderer/math/vector.h"

/// Small codes of directions and colours, for records that exist in millions.
namespace guidelight {

/// Unit direction in 24 bits: octahedral map, 12 bits per axis (Cigolle et al. 2014, "A Survey of
/// Efficient Representations for Independent Unit Vectors"). Off by at most 0.0011 rad; directions
/// along the axes are exact.
inline uint32_t pack_direction(Vec3 w) {
  const float sum = std::abs(w.x) + std::abs(w.y) + std::abs(w.z);
  Vec2 p = Vec2(w) / sum;
  if (w.z < 0) {  // the lower half is folded out over the corners of the square
    p = Vec2(std::copysign(1 - std::abs(p.y), w.x), std::copysign(1 - std::abs(p.x), w.y));
  }
  const auto x = static_cast<uint32_t>(p.x * 2047 + 2047.5f);
  const auto y = static_cast<uint32_t>(p.y * 2047 + 2047.5f);
  return x | y << 12;
}

/// The unit direction of the lowest 24 bits.
inline Vec3 unpack_direction(uint32_t code) {
  const float x = static_cast<float>(static_cast<int>(code & 0xfff) - 2047) / 2047;
  const float y = static_cast<float>(static_cast<int>(code >> 12 & 0xfff) - 2047) / 2047;
  const float z = 1 - std::abs(x) - std::abs(y);
  const float fold = std::max(-z, 0.0f);
  return glm::normalize(Vec3(x - std::copysign(fold, x), y - std::copysign(fold, y), z));
}

/// Colour in 32 bits: the largest channel as a float of 9 mantissa and 7 exponent bits, which of
/// the three it is, and the ratios of the two that follow it (cyclically) to it, 7 bits each.
///
/// Rounded up or down by chance, in proportion to the remainder, so that the mean over `dither`
/// (uniform bits) is the colour itself: millions of photons of one colour would otherwise share one
/// rounding error. The largest channel is off by less than 2⁻⁹ of itself, the others by less than
/// 1/127 of the largest, and the mean by less than 2.5e-7 of it. What is negative or not a number
/// counts as black, as does what is below 2⁻⁶³; what is above 2⁶⁴ is clamped.
inline uint32_t pack_color(Color color, uint64_t dither) {
  constexpr uint32_t kLowestExponent = 64u << 9;
  const Color c = glm::min(glm::max(Color(0.0f), color), Color(0x1p64f));  // NaN becomes 0
  uint32_t brightest = c.y > c.x ? 1 : 0;
  if (c.z > std::max(c.x, c.y)) brightest = 2;
  const float largest = max_component(c);
  if (!(largest >= 0x1p-63f)) return 0;

  // Carries from the mantissa into the exponent are what rounding up means.
  const uint32_t bits = std::bit_cast<uint32_t>(largest) + static_cast<uint32_t>(dither & 0x3fff);
  const uint32_t code = (bits >> 14) - kLowestExponent;
  const auto ratio = [&](float channel, uint64_t random_bits) {
    const float remainder = static_cast<float>(random_bits & 0xffff) * 0x1p-16f;
    return static_cast<uint32_t>(channel / largest * 127 + remainder);
  };
  const Color next = brightest == 0   ? c
                     : brightest == 1 ? Color(c.y, c.z, c.x)
                                      : Color(c.z, c.x, c.y);
  return code | brightest << 16 | ratio(next.y, dither >> 16) << 18 |
         ratio(next.z, dither >> 32) << 25;
}

inline Color unpack_color(uint32_t code) {
  constexpr uint32_t kLowestExponent = 64u << 9;
  if (code == 0) return Color(0.0f);
  const float largest = std::bit_cast<float>(((code & 0xffff) + kLowestExponent) << 14);
  const float unit = largest / 127;
  const float second = static_cast<float>(code >> 18 & 0x7f) * unit;
  const float third = static_cast<float>(code >> 25) * unit;
  switch (code >> 16 & 3) {
    case 0:
      return {largest, second, third};
    case 1:
      return {third, largest, second};
    default:
      return {second, third, largest};
  }
}

}  // namespace guidelight

#pragma once

#include <array>
#include <utility>
#include <vector>

#include "renderer/image/image.h"

namespace guidelight {

/// How often which value occurs, per channel, over a logarithmic axis in EV (powers of two).
struct Histogram {
  static constexpr int kBins = 96;
  static constexpr float kMinEv = -12;
  static constexpr float kMaxEv = 12;

  std::array<std::array<uint32_t, kBins>, 3> counts{};  // a grey image counts in all three
  uint32_t tallest = 0;                                 // of all bins
  uint64_t zero = 0;                                    // pixels without light, or negative
  uint64_t not_finite = 0;                              // pixels with a NaN or an infinity
};

Histogram make_histogram(const Image& image);

/// What all but the lowest 1 % and the highest 0.5 % of the positive, finite values lie between;
/// (0.01, 1) if there are none. The upper is always greater than the lower, which is positive.
std::pair<float, float> value_range(std::vector<float> values);

/// The same of the luminances of pixels.
std::pair<float, float> value_range(const Image& image);

}  // namespace guidelight

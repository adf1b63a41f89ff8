#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "renderer/math/vector.h"

namespace guidelight {

/// Discrete distribution over n ≥ 1 non-negative weights, by inversion (binary search in the CDF).
/// If all weights are zero it is uniform.
class DiscreteDistribution {
 public:
  struct Sample {
    uint32_t index;
    float pmf;       // discrete probability of `index`
    float remapped;  // u rescaled to [0,1) within the chosen interval, free to be used again
  };

  DiscreteDistribution() = default;
  explicit DiscreteDistribution(std::span<const float> weights);

  Sample sample(float u) const;
  float pmf(uint32_t index) const { return cdf_[index + 1] - cdf_[index]; }
  uint32_t size() const { return cdf_.empty() ? 0 : static_cast<uint32_t>(cdf_.size() - 1); }
  /// Sum of the weights as they were given.
  double total() const { return total_; }

 private:
  std::vector<float> cdf_;
  double total_ = 0;
};

inline DiscreteDistribution::Sample DiscreteDistribution::sample(float u) const {
  // The first entry above u closes the chosen interval, so intervals of width zero are never
  // chosen.
  const auto above = std::upper_bound(cdf_.begin() + 1, cdf_.end() - 1, u);
  const auto index = static_cast<uint32_t>(above - cdf_.begin() - 1);
  const float probability = pmf(index);
  const float remapped = probability > 0 ? (u - cdf_[index]) / probability : 0.0f;
  return {index, probability, std::clamp(remapped, 0.0f, kOneMinusEpsilon)};
}

/// Piecewise-constant density on [0,1)², from a row-major grid of non-negative values. Used to
/// sample images; `pdf` is per unit area of the square. If all values are zero it is uniform.
class GridDistribution {
 public:
  struct Sample {
    Vec2 position;
    float pdf;
  };

  GridDistribution() = default;
  /// values.size() must be width × height.
  GridDistribution(std::span<const float> values, int width, int height);

  Sample sample(Vec2 u) const;
  float pdf(Vec2 position) const;

 private:
  int width_ = 0;
  int height_ = 0;
  DiscreteDistribution rows_;
  std::vector<DiscreteDistribution> columns_;  // within each row
};

}  // namespace guidelight

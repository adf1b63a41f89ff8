#include "renderer/sampling/distribution.h"

#include <algorithm>

namespace guidelight {

DiscreteDistribution::DiscreteDistribution(std::span<const float> weights) {
  std::vector<double> sums(weights.size() + 1, 0.0);
  for (size_t i = 0; i < weights.size(); ++i) sums[i + 1] = sums[i] + weights[i];
  total_ = sums.back();
  cdf_.resize(sums.size());
  for (size_t i = 0; i < sums.size(); ++i) {
    cdf_[i] = static_cast<float>(total_ > 0 ? sums[i] / total_
                                            : static_cast<double>(i) / (sums.size() - 1));
  }
  cdf_.back() = 1.0f;
}

GridDistribution::GridDistribution(std::span<const float> values, int width, int height)
    : width_(width), height_(height) {
  std::vector<float> row_sums(height);
  columns_.reserve(height);
  for (int y = 0; y < height; ++y) {
    columns_.emplace_back(values.subspan(static_cast<size_t>(y) * width, width));
    row_sums[y] = static_cast<float>(columns_.back().total());
  }
  rows_ = DiscreteDistribution(row_sums);
}

GridDistribution::Sample GridDistribution::sample(Vec2 u) const {
  const auto row = rows_.sample(u.y);
  const auto column = columns_[row.index].sample(u.x);
  return {Vec2((column.index + column.remapped) / width_, (row.index + row.remapped) / height_),
          row.pmf * column.pmf * width_ * height_};
}

float GridDistribution::pdf(Vec2 position) const {
  const int x = std::clamp(static_cast<int>(position.x * width_), 0, width_ - 1);
  const int y = std::clamp(static_cast<int>(position.y * height_), 0, height_ - 1);
  return rows_.pmf(y) * columns_[y].pmf(x) * width_ * height_;
}

}  // namespace guidelight

#include "renderer/image/density_estimate.h"

#include <algorithm>

namespace guidelight {

void DensityEstimate::merge(const DensityEstimate& other) {
  emitted += other.emitted;
  if (!(other.radius_squared > 0)) return;
  if (!(radius_squared > 0) || count + other.count == 0) {
    const double all = emitted;
    *this = other;
    emitted = all;
    return;
  }
  // N/R² and τ/R² are the sums of the two.
  const Color flux_density = flux / radius_squared + other.flux / other.radius_squared;
  const float count_density = count / radius_squared + other.count / other.radius_squared;
  count += other.count;
  radius_squared = count / count_density;
  flux = flux_density * radius_squared;
}

DensityEstimates::DensityEstimates(int width, int height, int per_pixel)
    : width_(width),
      height_(height),
      per_pixel_(per_pixel),
      estimates_(static_cast<size_t>(width) * height * per_pixel),
      biases_(static_cast<size_t>(width) * height) {}

void DensityEstimates::add_bias(size_t pixel, double bias) {
  BiasSums& sums = biases_[pixel];
  sums.sum += bias;
  sums.squares += bias * bias;
  ++sums.samples;
}

float DensityEstimates::block_squared_bias(int block_x, int block_y) const {
  double sum = 0;
  int pixels = 0;
  for (int y = block_y * kBlock; y < std::min((block_y + 1) * kBlock, height_); ++y) {
    for (int x = block_x * kBlock; x < std::min((block_x + 1) * kBlock, width_); ++x) {
      const BiasSums& bias = biases_[static_cast<size_t>(y) * width_ + x];
      if (bias.samples < 2) continue;
      const double n = bias.samples;
      const double mean = bias.sum / n;
      const double variance = std::max(0.0, bias.squares / n - sqr(mean)) / (n - 1);
      sum += sqr(mean) - variance;
      ++pixels;
    }
  }
  return pixels > 0 ? static_cast<float>(std::max(0.0, sum / pixels)) : 0.0f;
}

std::vector<float> DensityEstimates::squared_bias(int y0, int y1) const {
  std::vector<float> result(static_cast<size_t>(y1 - y0) * width_);
  const int columns = (width_ + kBlock - 1) / kBlock;
  std::vector<float> blocks(columns);
  for (int y = y0; y < y1; ++y) {
    if (y == y0 || y % kBlock == 0) {
      for (int i = 0; i < columns; ++i) blocks[i] = block_squared_bias(i, y / kBlock);
    }
    for (int x = 0; x < width_; ++x) {
      result[static_cast<size_t>(y - y0) * width_ + x] = blocks[x / kBlock];
    }
  }
  return result;
}

void DensityEstimates::merge(const DensityEstimates& other) {
  for (size_t i = 0; i < estimates_.size(); ++i) estimates_[i].merge(other.estimates_[i]);
  for (size_t i = 0; i < biases_.size(); ++i) {
    biases_[i].sum += other.biases_[i].sum;
    biases_[i].squares += other.biases_[i].squares;
    biases_[i].samples += other.biases_[i].samples;
  }
}

}  // namespace guidelight

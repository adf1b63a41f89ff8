#include "renderer/image/technique_images.h"

#include <fmt/core.h>

#include <algorithm>

namespace guidelight {
namespace {

int blocks(int pixels, int block) { return (pixels + block - 1) / block; }

}  // namespace

std::string TechniqueImages::Technique::name() const {
  return fmt::format("{}_s{}_t{}", is_merging ? "merging" : "connection", s, t);
}

// Neither s nor t is above longest_path + 1.
TechniqueImages::TechniqueImages(int width, int height, int longest_path, int block)
    : width_(width),
      height_(height),
      longest_path_(longest_path),
      block_(block),
      columns_(blocks(width, block)),
      rows_(blocks(height, block)),
      sums_(2 * static_cast<size_t>(longest_path + 2) * (longest_path + 2)) {}

size_t TechniqueImages::index_of(const Technique& technique) const {
  const int side = longest_path_ + 2;
  return (static_cast<size_t>(technique.is_merging) * side + technique.s) * side + technique.t;
}

TechniqueImages::Technique TechniqueImages::technique_at(size_t index) const {
  const int side = longest_path_ + 2;
  const int i = static_cast<int>(index);
  return {.s = i / side % side, .t = i % side, .is_merging = i >= side * side};
}

void TechniqueImages::add(const Technique& technique, int x, int y, Color weighted, Color raw) {
  if (technique.path_length() > longest_path_) return;
  if (x < 0 || y < 0 || x >= width_ || y >= height_) return;
  Sums& sums = sums_[index_of(technique)];
  std::call_once(sums.made, [&] {
    sums.values = std::vector<std::atomic<float>>(6 * static_cast<size_t>(columns_) * rows_);
    bytes_ += sums.values.size() * sizeof(float);
  });
  const size_t block = static_cast<size_t>(y / block_) * columns_ + x / block_;
  std::atomic<float>* values = &sums.values[6 * block];
  for (int c = 0; c < 3; ++c) {
    values[c].fetch_add(weighted[c], std::memory_order_relaxed);
    values[3 + c].fetch_add(raw[c], std::memory_order_relaxed);
  }
}

std::map<TechniqueImages::Technique, TechniqueImages::Pair> TechniqueImages::develop(
    int shrink) const {
  std::map<Technique, Pair> result;
  for (size_t i = 0; i < sums_.size(); ++i) {
    if (!sums_[i].values.empty()) result[technique_at(i)] = develop(sums_[i], shrink);
  }
  return result;
}

TechniqueImages::Pair TechniqueImages::develop(const Technique& technique) const {
  if (technique.path_length() > longest_path_) return develop(Sums{}, 1);
  return develop(sums_[index_of(technique)], 1);
}

TechniqueImages::Pair TechniqueImages::develop(const Sums& sums, int shrink) const {
  const int width = blocks(columns_, shrink);
  const int height = blocks(rows_, shrink);
  Pair pair{Image(width, height, 3), Image(width, height, 3)};
  if (sums.values.empty() || passes_ == 0) return pair;
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column) {
      const std::atomic<float>* values =
          &sums.values[6 * (static_cast<size_t>(row) * columns_ + column)];
      float* weighted = pair.weighted.pixel(column / shrink, row / shrink);
      float* raw = pair.raw.pixel(column / shrink, row / shrink);
      for (int c = 0; c < 3; ++c) {
        weighted[c] += values[c].load(std::memory_order_relaxed);
        raw[c] += values[3 + c].load(std::memory_order_relaxed);
      }
    }
  }
  const int side = block_ * shrink;  // blocks at the right and lower edges hold fewer pixels
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const int pixels = std::min(side, width_ - x * side) * std::min(side, height_ - y * side);
      const float scale = 1.0f / (static_cast<float>(pixels) * static_cast<float>(passes_));
      for (int c = 0; c < 3; ++c) {
        pair.weighted.pixel(x, y)[c] *= scale;
        pair.raw.pixel(x, y)[c] *= scale;
      }
    }
  }
  return pair;
}

}  // namespace guidelight

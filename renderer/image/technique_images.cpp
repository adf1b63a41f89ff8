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
      samples_(static_cast<size_t>(width) * height),
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

void TechniqueImages::add_samples(const PixelRegion& pixels) {
  for (int y = pixels.y0; y < pixels.y1; ++y) {
    for (int x = pixels.x0; x < pixels.x1; ++x) ++samples_[static_cast<size_t>(y) * width_ + x];
  }
  ++samples_counted_;
}

std::vector<float> TechniqueImages::scales(bool from_light, int shrink) const {
  const int columns = blocks(columns_, shrink);
  const int side = block_ * shrink;
  std::vector<uint64_t> counted(static_cast<size_t>(columns) * blocks(rows_, shrink));
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      counted[static_cast<size_t>(y / side) * columns + x / side] +=
          from_light ? 1 : samples_[static_cast<size_t>(y) * width_ + x];
    }
  }
  // Light paths are of the whole picture.
  const auto pixels = static_cast<double>(samples_.size());
  const double of_each = !from_light        ? 1
                         : light_paths_ > 0 ? pixels / static_cast<double>(light_paths_)
                                            : 0;
  std::vector<float> result(counted.size());
  for (size_t i = 0; i < counted.size(); ++i) {
    result[i] = counted[i] > 0 ? static_cast<float>(of_each / static_cast<double>(counted[i])) : 0;
  }
  return result;
}

std::map<TechniqueImages::Technique, TechniqueImages::Pair> TechniqueImages::develop(
    int shrink) const {
  const std::vector<float> from_light = scales(true, shrink);
  const std::vector<float> others = scales(false, shrink);
  std::map<Technique, Pair> result;
  for (size_t i = 0; i < sums_.size(); ++i) {
    if (sums_[i].values.empty()) continue;
    const Technique technique = technique_at(i);
    result[technique] = develop(sums_[i], shrink, technique.t == 1 ? from_light : others);
  }
  return result;
}

TechniqueImages::Pair TechniqueImages::develop(const Technique& technique) const {
  const bool is_kept = technique.path_length() <= longest_path_;
  static const Sums kNone;
  return develop(is_kept ? sums_[index_of(technique)] : kNone, 1, scales(technique.t == 1, 1));
}

TechniqueImages::Pair TechniqueImages::develop(const Sums& sums, int shrink,
                                               std::span<const float> scales) const {
  const int width = blocks(columns_, shrink);
  const int height = blocks(rows_, shrink);
  Pair pair{Image(width, height, 3), Image(width, height, 3)};
  if (sums.values.empty()) return pair;
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column) {
      const int x = column / shrink, y = row / shrink;
      const float scale = scales[static_cast<size_t>(y) * width + x];
      const std::atomic<float>* values =
          &sums.values[6 * (static_cast<size_t>(row) * columns_ + column)];
      for (int c = 0; c < 3; ++c) {
        pair.weighted.pixel(x, y)[c] += scale * values[c].load(std::memory_order_relaxed);
        pair.raw.pixel(x, y)[c] += scale * values[3 + c].load(std::memory_order_relaxed);
      }
    }
  }
  return pair;
}

}  // namespace guidelight

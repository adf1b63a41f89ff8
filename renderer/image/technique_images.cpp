#include "renderer/image/technique_images.h"

#include <fmt/core.h>

namespace guidelight {

std::string TechniqueImages::Technique::name() const {
  return fmt::format("{}_s{}_t{}", is_merging ? "merging" : "connection", s, t);
}

TechniqueImages::Sums& TechniqueImages::sums_of(const Technique& technique) {
  const std::lock_guard lock(mutex_);
  std::unique_ptr<Sums>& sums = sums_[technique];
  if (!sums) {
    sums = std::make_unique<Sums>(
        Sums{std::vector<std::atomic<float>>(6 * static_cast<size_t>(width_) * height_)});
  }
  return *sums;
}

void TechniqueImages::add(const Technique& technique, int x, int y, Color weighted, Color raw) {
  const int length = technique.s + technique.t - (technique.is_merging ? 2 : 1);
  if (length > kLongestPath || x < 0 || y < 0 || x >= width_ || y >= height_) return;
  std::atomic<float>* sums = &sums_of(technique).values[6 * (static_cast<size_t>(y) * width_ + x)];
  for (int c = 0; c < 3; ++c) {
    sums[c].fetch_add(weighted[c], std::memory_order_relaxed);
    sums[3 + c].fetch_add(raw[c], std::memory_order_relaxed);
  }
}

void TechniqueImages::add_samples(const PixelRegion& pixels) {
  for (int y = pixels.y0; y < pixels.y1; ++y) {
    for (int x = pixels.x0; x < pixels.x1; ++x) ++samples_[static_cast<size_t>(y) * width_ + x];
  }
}

float TechniqueImages::scale(const Technique& technique, size_t pixel) const {
  if (technique.t == 1) {
    const auto pixels = static_cast<float>(samples_.size());
    return light_paths_ > 0 ? pixels / static_cast<float>(light_paths_) : 0.0f;
  }
  return samples_[pixel] > 0 ? 1 / static_cast<float>(samples_[pixel]) : 0.0f;
}

std::map<TechniqueImages::Technique, TechniqueImages::Pair> TechniqueImages::develop() const {
  const std::lock_guard lock(mutex_);
  std::map<Technique, Pair> result;
  for (const auto& [technique, sums] : sums_) {
    Pair& pair = result[technique];
    pair.weighted = pair.raw = Image(width_, height_, 3);
    for (size_t i = 0; i < pair.weighted.data().size(); ++i) {
      const size_t from = i / 3 * 6 + i % 3;
      const float share = scale(technique, i / 3);
      pair.weighted.data()[i] = share * sums->values[from].load(std::memory_order_relaxed);
      pair.raw.data()[i] = share * sums->values[from + 3].load(std::memory_order_relaxed);
    }
  }
  return result;
}

}  // namespace guidelight

#pragma once

#include <atomic>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "renderer/image/image.h"
#include "renderer/image/pixel_region.h"

namespace guidelight {

/// What each technique of a bidirectional method brought, by its numbers of vertices on the light's
/// side (s) and the camera's (t): Veach's pyramid, with a row of merging beside each of connection.
/// Kept only when somebody wants to see it.
class TechniqueImages {
 public:
  struct Technique {
    int s = 0;
    int t = 0;
    bool is_merging = false;
    auto operator<=>(const Technique&) const = default;
    /// For layers of a file, e.g. "connection_s2_t3".
    std::string name() const;
  };
  /// Longer paths are not kept apart, they would be thousands of pictures.
  static constexpr int kLongestPath = 9;  // segments

  TechniqueImages(int width, int height)
      : width_(width), height_(height), samples_(static_cast<size_t>(width) * height) {}

  int width() const { return width_; }
  int height() const { return height_; }

  /// Adds a contribution to a pixel: as the balance heuristic weighs it, and as the technique would
  /// count it alone; of t = 1 to the whole picture. Thread safe.
  void add(const Technique& technique, int x, int y, Color weighted, Color raw);
  // As of a film, what is counted is camera paths of each pixel and light paths of all, so that a
  // pass that is given up leaves the right images.
  /// One more camera path of each pixel. Different pixels may be counted by different threads.
  void add_samples(const PixelRegion& pixels);
  /// Of light paths that were connected to the lens, t = 1. Thread safe.
  void add_light_paths(uint64_t count) { light_paths_ += count; }

  struct Pair {
    Image weighted;
    Image raw;
  };
  /// All that received anything. Not while anything is added.
  std::map<Technique, Pair> develop() const;

 private:
  struct Sums {
    std::vector<std::atomic<float>> values;  // 6 per pixel: weighted and raw
  };
  Sums& sums_of(const Technique& technique);
  /// What the sums of a pixel are multiplied by.
  float scale(const Technique& technique, size_t pixel) const;

  int width_;
  int height_;
  std::vector<uint32_t> samples_;  // per pixel
  std::atomic<uint64_t> light_paths_{0};
  mutable std::mutex mutex_;
  std::map<Technique, std::unique_ptr<Sums>> sums_;
};

}  // namespace guidelight

#pragma once

#include <atomic>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "renderer/image/image.h"

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

  TechniqueImages(int width, int height) : width_(width), height_(height) {}

  int width() const { return width_; }
  int height() const { return height_; }

  /// Adds a contribution to a pixel: as the balance heuristic weighs it, and as the technique would
  /// count it alone. Thread safe.
  void add(const Technique& technique, int x, int y, Color weighted, Color raw);
  /// Ends a pass: the images are means over passes.
  void finish_pass() { ++passes_; }

  struct Pair {
    Image weighted;
    Image raw;
  };
  /// All that received anything. Not while a pass is under way.
  std::map<Technique, Pair> develop() const;

 private:
  struct Sums {
    std::vector<std::atomic<float>> values;  // 6 per pixel: weighted and raw
  };
  Sums& sums_of(const Technique& technique);

  int width_;
  int height_;
  uint32_t passes_ = 0;
  mutable std::mutex mutex_;
  std::map<Technique, std::unique_ptr<Sums>> sums_;
};

}  // namespace guidelight

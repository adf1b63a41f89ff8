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
    /// Of the paths that it makes [segments]; a merged path has one vertex that is of both sides.
    int path_length() const { return s + t - (is_merging ? 2 : 1); }
    /// For layers of a file, e.g. "connection_s2_t3".
    std::string name() const;
  };
  /// Longer paths are not kept apart, they would be thousands of pictures.
  static constexpr int kLongestPath = 9;  // segments

  /// Squares of `block` × `block` pixels are kept as one, which saves memory.
  TechniqueImages(int width, int height, int longest_path = kLongestPath, int block = 1);

  /// Of the pictures that are kept [blocks].
  int width() const { return columns_; }
  int height() const { return rows_; }
  int longest_path() const { return longest_path_; }
  /// Held for the techniques that have brought anything yet [bytes]. Thread safe.
  size_t bytes() const { return bytes_; }

  /// Adds a contribution to a pixel: as the balance heuristic weighs it, and as the technique would
  /// count it alone. Thread safe.
  void add(const Technique& technique, int x, int y, Color weighted, Color raw);
  /// Ends a pass: the images are means over passes.
  void finish_pass() { ++passes_; }
  uint32_t passes() const { return passes_; }

  struct Pair {
    Image weighted;
    Image raw;
  };
  /// All that received anything, smaller by a factor. Not while a pass is under way.
  std::map<Technique, Pair> develop(int shrink = 1) const;
  /// One of them; black if it received nothing. Not while a pass is under way.
  Pair develop(const Technique& technique) const;

 private:
  struct Sums {
    std::once_flag made;
    std::vector<std::atomic<float>> values;  // 6 per block: weighted and raw
  };
  size_t index_of(const Technique& technique) const;
  Technique technique_at(size_t index) const;
  Pair develop(const Sums& sums, int shrink) const;

  int width_;
  int height_;
  int longest_path_;
  int block_;
  int columns_;
  int rows_;
  uint32_t passes_ = 0;
  std::atomic<size_t> bytes_ = 0;
  std::vector<Sums> sums_;  // by index_of
};

}  // namespace guidelight

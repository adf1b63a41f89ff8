#pragma once

#include <mutex>
#include <vector>

#include "renderer/image/film.h"

namespace guidelight {

/// How the density estimates of single pixels develop, for whoever picks pixels to look at. Both
/// sides may call at any time from any thread.
class PixelHistory {
 public:
  struct Pixel {
    int x = 0;
    int y = 0;
    bool operator==(const Pixel&) const = default;
  };
  /// State after a pass.
  struct Entry {
    double emitted;  // light paths so far
    float count;     // N, mean over the pixel's density estimates
    float radius;    // R, mean over the same [scene units]
    Color estimate;  // the pixel of the beauty layer
    float error;     // expected error of the estimate's luminance
  };

  /// Watches these pixels from the next pass on. What is known about others is forgotten.
  void watch(const std::vector<Pixel>& pixels);
  /// What has been recorded about a pixel, in order. Long histories are thinned out: entries are
  /// then evenly spaced, and the last may be some passes old.
  std::vector<Entry> of(Pixel pixel) const;

  /// Called by integrators at the end of a pass.
  void record(const Film& film);

 private:
  static constexpr size_t kMostEntries = 4096;
  struct Record {
    Pixel pixel;
    std::vector<Entry> entries = {};
    uint64_t passes = 0;
    uint64_t stride = 1;  // passes per entry
  };

  mutable std::mutex mutex_;
  std::vector<Record> records_;
};

}  // namespace guidelight

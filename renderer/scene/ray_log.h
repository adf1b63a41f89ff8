#pragma once

#include <mutex>
#include <span>
#include <vector>

#include "renderer/math/ray.h"

namespace guidelight {

/// Rays as they were traced, batch by batch, so that a benchmark can replay them without a
/// renderer.
class RayLog {
 public:
  struct Batch {
    bool shadow;
    std::vector<Ray> rays;
  };

  void add(bool shadow, std::span<const Ray> rays) {
    if (rays.empty()) return;
    const std::lock_guard lock(mutex_);
    batches_.push_back({shadow, {rays.begin(), rays.end()}});
  }
  const std::vector<Batch>& batches() const { return batches_; }

 private:
  std::mutex mutex_;
  std::vector<Batch> batches_;
};

}  // namespace guidelight

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
    bool in_packets;  // or one by one
    std::vector<Ray> rays;
  };

  void add(bool shadow, std::span<const Ray> rays) {
    if (rays.empty()) return;
    const std::lock_guard lock(mutex_);
    batches_.push_back({shadow, true, {rays.begin(), rays.end()}});
  }
  /// A ray that is traced by itself.
  void add(bool shadow, const Ray& ray) {
    const std::lock_guard lock(mutex_);
    const bool continues = !batches_.empty() && !batches_.back().in_packets &&
                           batches_.back().shadow == shadow && batches_.back().rays.size() < kMost;
    if (!continues) batches_.push_back({shadow, false, {}});
    batches_.back().rays.push_back(ray);
  }
  const std::vector<Batch>& batches() const { return batches_; }

 private:
  static constexpr size_t kMost = 64;  // one by one

  std::mutex mutex_;
  std::vector<Batch> batches_;
};

}  // namespace guidelight

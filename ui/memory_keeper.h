#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

#include "ui/background_thread.h"

namespace guidelight {

/// Keeps the program from growing while renders come and go: what they used is freed in pieces all
/// over the allocator's arenas, which would keep it for good. As long as there are new pictures,
/// and once after the last, free pages are given back.
class MemoryKeeper {
 public:
  using Clock = std::chrono::steady_clock;

  /// To be called once per frame, with the number of the latest picture.
  void update(uint64_t picture, Clock::time_point now);
  /// Whether it wants to be called again without an event.
  bool pending() const { return due_.has_value(); }

 private:
  uint64_t picture_ = 0;
  std::optional<Clock::time_point> due_;
  BackgroundThread worker_;  // arenas are locked meanwhile, but the window must not wait for all
};

}  // namespace guidelight

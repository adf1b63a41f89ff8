#pragma once

#include <chrono>

namespace guidelight {

/// Seconds of wall-clock time since it was started, pauses excluded.
class Stopwatch {
 public:
  void restart() { *this = Stopwatch(); }

  void set_paused(bool paused) {
    if (paused == paused_) return;
    if (paused) before_ = seconds();
    paused_ = paused;
    start_ = Clock::now();
  }

  double seconds() const {
    if (paused_) return before_;
    return before_ + std::chrono::duration<double>(Clock::now() - start_).count();
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
  double before_ = 0;
  bool paused_ = false;
};

}  // namespace guidelight

#pragma once

#include <cstddef>
#include <functional>
#include <memory>

namespace guidelight {

/// Thrown out of a loop that was told to stop.
struct Stopped {};

/// Pause and stop, shared between the thread that asks and the threads that render. Never blocks the asker.
class RenderControl {
 public:
  RenderControl();
  ~RenderControl();
  void request_stop();
  bool stop_requested() const;
  void set_paused(bool paused);
  bool paused() const;
  /// Waits while paused; returns false if the work must be given up.
  bool may_continue();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// The one parallel loop: a fixed number of threads of their own, with denormals flushed to zero.
class Parallel {
 public:
  /// threads 0 takes all processors. `control` may be null and must outlive this.
  explicit Parallel(int threads = 0, RenderControl* control = nullptr);
  ~Parallel();

  int threads() const;

  /// Calls body(i) for each i in [0,count), in any order on any thread; between calls it waits while
  /// paused. Throws Stopped when told to stop, or the first exception of a body.
  void for_each(size_t count, const std::function<void(size_t)>& body);

 private:
  struct Arena;
  std::unique_ptr<Arena> arena_;
  RenderControl* control_;
};

}  // namespace guidelight

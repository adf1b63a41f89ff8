#pragma once

#include <cstddef>
#include <functional>
#include <memory>

namespace guidelight {

/// Thrown out of a loop that was told to stop.
struct Stopped {};

/// Pause and stop, shared between the thread that asks and the threads that work. Asking never
/// blocks.
class WorkControl {
 public:
  WorkControl();
  ~WorkControl();
  WorkControl(const WorkControl&) = delete;
  WorkControl& operator=(const WorkControl&) = delete;

  void request_stop();
  bool stop_requested() const;
  void set_paused(bool paused);

  /// Called by workers between pieces of work: waits while paused, then returns false if the work
  /// must be given up.
  bool may_continue();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

enum class Priority { Normal, Background };  // Background yields to the user interface

/// The one parallel loop: a fixed number of threads, with denormals flushed to zero while they
/// work.
class Parallel {
 public:
  /// threads 0 takes all processors. `control` may be null and must outlive this.
  explicit Parallel(int threads = 0, WorkControl* control = nullptr,
                    Priority priority = Priority::Normal);
  ~Parallel();
  Parallel(const Parallel&) = delete;
  Parallel& operator=(const Parallel&) = delete;

  int threads() const;

  /// Calls body(i) for each i in [0,count), in any order on any thread; between calls it waits
  /// while paused. Throws Stopped when told to stop, or the first exception of a body. Nested calls
  /// are allowed.
  void for_each(size_t count, const std::function<void(size_t)>& body);

 private:
  struct Arena;
  std::unique_ptr<Arena> arena_;
  WorkControl* control_;
};

}  // namespace guidelight

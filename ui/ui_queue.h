#pragma once

#include <deque>
#include <functional>
#include <mutex>

namespace guidelight {

/// The one way for other threads to reach the user interface: they post functions, the UI thread
/// runs them between frames. Thread safe.
class UiQueue {
 public:
  /// `wake` is called after each post, from the posting thread, to end the event loop's wait.
  explicit UiQueue(std::function<void()> wake) : wake_(std::move(wake)) {}

  void post(std::function<void()> function);
  /// Runs what was posted, in order. If one throws, the rest is for the next time. UI thread only.
  void run();
  /// Drops what was posted and all later posts; for the time when nobody is there to run them.
  void close();

 private:
  std::mutex mutex_;
  std::function<void()> wake_;
  std::deque<std::function<void()>> functions_;
  bool closed_ = false;
};

}  // namespace guidelight

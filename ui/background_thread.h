#pragma once

#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

namespace guidelight {

/// Why something failed, as a sentence: what an Error says; if memory was short, that with what was
/// tried, "Cannot write 'a.exr'".
std::string sentence_about(const std::exception& error, const std::string& attempt);

/// Runs jobs one after another in a thread of its own. The destructor finishes all of them first.
class BackgroundThread {
 public:
  BackgroundThread();
  ~BackgroundThread();
  BackgroundThread(const BackgroundThread&) = delete;
  BackgroundThread& operator=(const BackgroundThread&) = delete;

  /// If the job throws, `failed` is called in that thread with the reason. Neither that nor jobs
  /// without it may throw.
  void run(std::function<void()> job, std::function<void(const std::string& reason)> failed = {});

 private:
  void work();

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::function<void()>> jobs_;
  bool ending_ = false;
  std::thread thread_;  // last: it uses all the others
};

}  // namespace guidelight

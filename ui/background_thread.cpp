#include "ui/background_thread.h"

#include <new>
#include <utility>

namespace guidelight {

std::string sentence_about(const std::exception& error, const std::string& attempt) {
  const bool is_short_of_memory = dynamic_cast<const std::bad_alloc*>(&error) != nullptr;
  return is_short_of_memory ? attempt + ": there is not enough memory; close other programs."
                            : error.what();
}

BackgroundThread::BackgroundThread() : thread_([this] { work(); }) {}

BackgroundThread::~BackgroundThread() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  changed_.notify_one();
  thread_.join();
}

void BackgroundThread::run(std::function<void()> job,
                           std::function<void(const std::string&)> failed) {
  if (failed) {
    job = [job = std::move(job), failed = std::move(failed)] {
      try {
        job();
      } catch (const std::bad_alloc&) {
        failed("there is not enough memory");
      } catch (const std::exception& error) {
        failed(error.what());
      }
    };
  }
  {
    const std::lock_guard lock(mutex_);
    jobs_.push_back(std::move(job));
  }
  changed_.notify_one();
}

void BackgroundThread::work() {
  std::unique_lock lock(mutex_);
  for (;;) {
    changed_.wait(lock, [this] { return ending_ || !jobs_.empty(); });
    if (jobs_.empty()) return;
    const std::function<void()> job = std::move(jobs_.front());
    jobs_.pop_front();
    lock.unlock();
    job();
    lock.lock();
  }
}

}  // namespace guidelight

#include "ui/ui_queue.h"

#include <utility>

namespace guidelight {

void UiQueue::post(std::function<void()> function) {
  const std::lock_guard lock(mutex_);
  if (closed_) return;
  functions_.push_back(std::move(function));
  wake_();  // under the lock: after close() returns nobody calls it any more
}

void UiQueue::run() {
  std::unique_lock lock(mutex_);
  for (size_t left = functions_.size(); left > 0; --left) {
    const std::function<void()> function = std::move(functions_.front());
    functions_.pop_front();
    lock.unlock();
    function();
    lock.lock();
  }
}

void UiQueue::close() {
  const std::lock_guard lock(mutex_);
  closed_ = true;
  functions_.clear();
}

}  // namespace guidelight

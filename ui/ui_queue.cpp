#include "ui/ui_queue.h"

namespace guidelight {

void UiQueue::post(std::function<void()> function) {
  const std::lock_guard lock(mutex_);
  if (closed_) return;
  functions_.push_back(std::move(function));
  wake_();  // under the lock: after close() returns nobody calls it any more
}

void UiQueue::run() {
  std::vector<std::function<void()>> functions;
  {
    const std::lock_guard lock(mutex_);
    functions.swap(functions_);
  }
  for (const auto& function : functions) function();
}

void UiQueue::close() {
  const std::lock_guard lock(mutex_);
  closed_ = true;
  functions_.clear();
}

}  // namespace guidelight

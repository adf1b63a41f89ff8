#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <vector>

namespace guidelight {

/// Objects that pieces of parallel work borrow in turn, so that their memory is allocated once per
/// thread and not once per piece.
template <typename T>
class ObjectPool {
 public:
  explicit ObjectPool(std::function<std::unique_ptr<T>()> make) : make_(std::move(make)) {}

  /// Calls use(object) with an object that nobody else uses.
  template <typename Use>
  void with(Use&& use) {
    std::unique_ptr<T> object = take();
    use(*object);
    const std::lock_guard lock(mutex_);
    idle_.push_back(std::move(object));
  }

 private:
  std::unique_ptr<T> take() {
    {
      const std::lock_guard lock(mutex_);
      if (!idle_.empty()) {
        std::unique_ptr<T> object = std::move(idle_.back());
        idle_.pop_back();
        return object;
      }
    }
    return make_();
  }

  std::function<std::unique_ptr<T>()> make_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<T>> idle_;
};

}  // namespace guidelight

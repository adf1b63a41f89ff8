#pragma once

#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>

namespace guidelight {

/// An array of zeros whose memory is only claimed where it is touched. Making a large one takes no
/// time, and its pages are filled in by the threads that write to them.
template <typename T>
class ZeroedArray {
  static_assert(std::is_trivially_copyable_v<T> && alignof(T) <= alignof(std::max_align_t));

 public:
  ZeroedArray() = default;
  explicit ZeroedArray(size_t size)
      : size_(size), values_(static_cast<T*>(std::calloc(size, sizeof(T)))) {
    if (size > 0 && !values_) throw std::bad_alloc();
  }
  ZeroedArray(const ZeroedArray& other) : ZeroedArray(other.size_) {
    if (size_ > 0) std::memcpy(values_.get(), other.values_.get(), size_ * sizeof(T));
  }
  ZeroedArray(ZeroedArray&& other) noexcept { swap(other); }
  ZeroedArray& operator=(ZeroedArray other) noexcept {
    swap(other);
    return *this;
  }

  size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  T& operator[](size_t i) { return values_[i]; }
  const T& operator[](size_t i) const { return values_[i]; }
  T* begin() { return values_.get(); }
  T* end() { return values_.get() + size_; }
  const T* begin() const { return values_.get(); }
  const T* end() const { return values_.get() + size_; }

 private:
  struct Free {
    void operator()(T* values) const { std::free(values); }
  };

  void swap(ZeroedArray& other) noexcept {
    std::swap(size_, other.size_);
    std::swap(values_, other.values_);
  }

  size_t size_ = 0;
  std::unique_ptr<T[], Free> values_;
};

}  // namespace guidelight

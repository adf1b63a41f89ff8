#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace guidelight {

/// A number that the threads of one Parallel count up together, each in a cell of its own: counting
/// takes a few instructions and no cache line wanders between processors.
class WorkerCounter {
 public:
  /// For the threads of a Parallel of that many. Two of these at the same time would lose counts.
  explicit WorkerCounter(int threads);

  void add(uint64_t count);
  /// From any thread, at any time.
  uint64_t total() const;

 private:
  struct alignas(64) Cell {
    std::atomic<uint64_t> value = 0;
  };
  std::vector<Cell> cells_;
};

}  // namespace guidelight

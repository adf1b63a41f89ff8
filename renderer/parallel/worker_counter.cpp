#include "renderer/parallel/worker_counter.h"

#include <tbb/task_arena.h>

namespace guidelight {

WorkerCounter::WorkerCounter(int threads) : cells_(static_cast<size_t>(threads)) {}

/// The thread that starts a loop takes part in it, so outside of loops it may use the first cell.
void WorkerCounter::add(uint64_t count) {
  const int index = tbb::this_task_arena::current_thread_index();
  const bool is_worker = index > 0 && index < static_cast<int>(cells_.size());
  std::atomic<uint64_t>& value = cells_[is_worker ? index : 0].value;
  // No other thread writes to this cell, so this needs no locked instruction.
  value.store(value.load(std::memory_order_relaxed) + count, std::memory_order_relaxed);
}

uint64_t WorkerCounter::total() const {
  uint64_t sum = 0;
  for (const Cell& cell : cells_) sum += cell.value.load(std::memory_order_relaxed);
  return sum;
}

}  // namespace guidelight

#include "renderer/parallel/worker_counter.h"

#include <utility>

namespace guidelight {
namespace {

thread_local int place = 0;  // asking oneTBB for each ray would cost Markov chains another per cent

}  // namespace

WorkerCounter::Place::Place(int index) : outer_(std::exchange(place, index)) {}
WorkerCounter::Place::~Place() { place = outer_; }

WorkerCounter::WorkerCounter(int threads) : cells_(static_cast<size_t>(threads)) {}

void WorkerCounter::add(uint64_t count) {
  const auto index = static_cast<size_t>(place);
  std::atomic<uint64_t>& value = cells_[index < cells_.size() ? index : 0].value;
  // No other thread writes to this cell, so this needs no locked instruction.
  value.store(value.load(std::memory_order_relaxed) + count, std::memory_order_relaxed);
}

uint64_t WorkerCounter::total() const {
  uint64_t sum = 0;
  for (const Cell& cell : cells_) sum += cell.value.load(std::memory_order_relaxed);
  return sum;
}

}  // namespace guidelight

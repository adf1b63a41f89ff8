#include "ui/memory_keeper.h"

#include "renderer/parallel/process_memory.h"

namespace guidelight {
namespace {

constexpr std::chrono::seconds kCalm{1};  // also the least time between two

}  // namespace

void MemoryKeeper::update(uint64_t job, Clock::time_point now) {
  if (job != job_ && !due_) due_ = now + kCalm;
  job_ = job;
  if (!due_ || now < *due_) return;
  due_.reset();
  worker_.run(return_free_pages_to_the_system);
}

}  // namespace guidelight

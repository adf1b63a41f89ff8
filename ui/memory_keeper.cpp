#include "ui/memory_keeper.h"

#include "renderer/parallel/process_memory.h"

namespace guidelight {
namespace {

constexpr std::chrono::seconds kInterval{2};

}  // namespace

void MemoryKeeper::update(uint64_t picture, Clock::time_point now) {
  if (picture != picture_ && !due_) due_ = now + kInterval;
  picture_ = picture;
  if (!due_ || now < *due_) return;
  due_.reset();
  worker_.run(return_free_pages_to_the_system);
}

}  // namespace guidelight

#include "renderer/parallel/worker_counter.h"

#include <gtest/gtest.h>

#include "renderer/parallel/parallel.h"

namespace guidelight {
namespace {

TEST(WorkerCounter, loses_nothing_in_loops_of_several_threads_and_between_them) {
  constexpr size_t kCount = 200'000;
  for (const int threads : {1, 4}) {
    WorkerCounter counter(threads);
    Parallel parallel(threads);
    counter.add(5);
    parallel.for_each(kCount, [&](size_t i) { counter.add(i % 3); });
    parallel.for_each(kCount, [&](size_t) { counter.add(1); });
    EXPECT_EQ(counter.total(), 5 + (kCount / 3) * 3 + 1 + kCount) << threads << " threads";
  }
}

}  // namespace
}  // namespace guidelight

#include "renderer/parallel/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <limits>
#include <stdexcept>
#include <thread>
#include <vector>

namespace guidelight {
namespace {

TEST(Parallel, runs_every_index_once) {
  Parallel parallel(2);
  EXPECT_EQ(parallel.threads(), 2);
  std::vector<std::atomic<int>> count(1000);
  parallel.for_each(count.size(), [&](size_t i) { ++count[i]; });
  for (const auto& n : count) EXPECT_EQ(n, 1);
}

TEST(Parallel, stops_between_pieces_of_work) {
  WorkControl control;
  Parallel parallel(2, &control);
  std::atomic<int> done{0};
  EXPECT_THROW(parallel.for_each(100000,
                                 [&](size_t) {
                                   if (++done == 10) control.request_stop();
                                 }),
               Stopped);
  EXPECT_LT(done, 100);
}

TEST(Parallel, waits_while_paused) {
  WorkControl control;
  control.set_paused(true);
  std::atomic<int> done{0};
  std::thread worker([&] { Parallel(2, &control).for_each(10, [&](size_t) { ++done; }); });
  std::this_thread::sleep_for(std::chrono::milliseconds(30));
  EXPECT_EQ(done, 0);
  control.set_paused(false);
  worker.join();
  EXPECT_EQ(done, 10);
}

TEST(Parallel, passes_an_exception_on) {
  Parallel parallel(2);
  EXPECT_THROW(parallel.for_each(100,
                                 [](size_t i) {
                                   if (i == 50) throw std::runtime_error("x");
                                 }),
               std::runtime_error);
}

TEST(Parallel, flushes_denormals_in_its_threads_only) {
  volatile float tiny = std::numeric_limits<float>::min();
  std::atomic<int> kept{0};
  Parallel(2).for_each(100, [&](size_t) {
    if (tiny / 4 != 0) ++kept;
  });
  EXPECT_EQ(kept, 0);
  EXPECT_NE(tiny / 4, 0);
}

}  // namespace
}  // namespace guidelight

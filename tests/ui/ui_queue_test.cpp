#include "ui/ui_queue.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <stdexcept>
#include <thread>

#include "ui/background_thread.h"

namespace guidelight {
namespace {

TEST(UiQueue, RunsInOrderOnTheThreadThatAsks) {
  int wakes = 0;
  UiQueue queue([&] { ++wakes; });
  std::vector<int> order;
  queue.post([&] { order.push_back(1); });
  queue.post([&] {
    order.push_back(2);
    queue.post([&] { order.push_back(3); });  // for the next time
  });
  EXPECT_EQ(wakes, 2);
  queue.run();
  EXPECT_EQ(order, (std::vector{1, 2}));
  queue.run();
  EXPECT_EQ(order, (std::vector{1, 2, 3}));
}

TEST(UiQueue, KeepsTheRestWhenOneThrows) {
  UiQueue queue([] {});
  bool ran = false;
  queue.post([] { throw std::runtime_error("no"); });
  queue.post([&] { ran = true; });
  EXPECT_THROW(queue.run(), std::runtime_error);
  EXPECT_FALSE(ran);
  queue.run();
  EXPECT_TRUE(ran);
}

TEST(UiQueue, DropsEverythingOnceClosed) {
  int wakes = 0;
  UiQueue queue([&] { ++wakes; });
  bool ran = false;
  queue.post([&] { ran = true; });
  queue.close();
  queue.post([&] { ran = true; });
  queue.run();
  EXPECT_FALSE(ran);
  EXPECT_EQ(wakes, 1);
}

TEST(UiQueue, LosesNothingThatManyThreadsPost) {
  UiQueue queue([] {});
  std::vector<std::thread> threads;
  int count = 0;
  for (int t = 0; t < 4; ++t) {
    threads.emplace_back([&] {
      for (int i = 0; i < 1000; ++i) queue.post([&] { ++count; });
    });
  }
  while (count < 2000) queue.run();
  for (std::thread& thread : threads) thread.join();
  queue.run();
  EXPECT_EQ(count, 4000);
}

TEST(BackgroundThread, FinishesItsJobsInOrderBeforeItGoes) {
  std::vector<int> order;
  {
    BackgroundThread thread;
    for (int i = 0; i < 100; ++i) thread.run([&order, i] { order.push_back(i); });
  }
  ASSERT_EQ(order.size(), 100u);
  EXPECT_TRUE(std::ranges::is_sorted(order));
}

TEST(BackgroundThread, SaysWhyAJobFailedAndGoesOn) {
  std::vector<std::string> said;
  {
    BackgroundThread thread;
    const auto failed = [&](const std::string& reason) { said.push_back(reason); };
    thread.run([] { throw std::runtime_error("no"); }, failed);
    thread.run([] { throw std::bad_alloc(); }, failed);
    thread.run([&] { said.emplace_back("done"); }, failed);
  }
  EXPECT_EQ(said, (std::vector<std::string>{"no", "there is not enough memory", "done"}));
}

TEST(BackgroundThread, ShortMemoryIsSaidWithWhatWasTried) {
  const std::string attempt = "Cannot read 'huge.exr'";
  EXPECT_EQ(sentence_about(std::bad_alloc(), attempt),
            "Cannot read 'huge.exr': there is not enough memory; close other programs.");
  EXPECT_EQ(sentence_about(std::runtime_error("It is broken."), attempt), "It is broken.");
}

}  // namespace
}  // namespace guidelight

#include "ui/guides/guide_saver.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <thread>

#include "renderer/io/guide_file.h"
#include "tests/renderer/test_scenes.h"

namespace guidelight {
namespace {

using namespace std::chrono_literals;
namespace fs = std::filesystem;

class GuideSaverTest : public ::testing::Test {
 protected:
  void SetUp() override {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    SceneDescription room = testing::room(8, 8);
    room.path = (folder_ / "room.xml").string();
    document_.open({room.path, {}, testing::build(std::move(room)), {}, {}});
    saver_->update(now_);
  }
  void TearDown() override {
    fs::create_directories(folder_);
    saver_.reset();
    fs::remove_all(folder_);
  }

  /// Edits, and waits until the change is calm enough to be saved.
  void edit(const std::string& name) {
    GuidePath guide;
    guide.name = name;
    guide.vertices.resize(2);
    guide.vertices[1].position = {0, 0, 1};
    document_.edit_guides({guide}, "test");
    saver_->update(now_);
    saver_->update(now_ += 1s);
  }

  bool update_until(const std::function<bool()>& condition) {
    const auto end = Document::Clock::now() + 10s * GUIDELIGHT_SLOWDOWN;
    while (!condition() && Document::Clock::now() < end) {
      queue_.run();
      saver_->update(now_);
      std::this_thread::sleep_for(1ms);
    }
    return condition();
  }

  std::string saved_name() const {
    return fs::is_regular_file(file_) ? read_guides(file_.string()).front().name : "";
  }

  // Tests may run beside each other.
  const fs::path folder_ = fs::path(::testing::TempDir()) /
                           (std::string("guidelight_guide_saver_") +
                            ::testing::UnitTest::GetInstance()->current_test_info()->name());
  const fs::path file_ = folder_ / "room.guides.json";
  UiQueue queue_{[] {}};
  Document document_{[] {}};
  Document::Clock::time_point now_ = Document::Clock::now();
  std::unique_ptr<GuideSaver> saver_ = std::make_unique<GuideSaver>(document_, queue_);
};

TEST_F(GuideSaverTest, SavesAMomentAfterAChange) {
  edit("a");
  EXPECT_TRUE(update_until([&] { return saved_name() == "a"; }));
  edit("b");
  EXPECT_TRUE(update_until([&] { return saved_name() == "b"; }));
  EXPECT_TRUE(document_.messages().shown().empty());
}

TEST_F(GuideSaverTest, WhatCouldNotBeSavedIsTriedAgainAtTheEnd) {
  fs::remove_all(folder_);
  edit("a");
  ASSERT_TRUE(update_until([&] { return !document_.messages().shown().empty(); }));
  EXPECT_FALSE(saver_->pending()) << "not again and again";
  fs::create_directories(folder_);
  saver_.reset();
  EXPECT_EQ(saved_name(), "a");
}

TEST_F(GuideSaverTest, AFailureAtTheEndIsPrinted) {
  fs::remove_all(folder_);
  edit("a");
  queue_.close();
  ::testing::internal::CaptureStderr();
  saver_.reset();
  EXPECT_NE(::testing::internal::GetCapturedStderr().find("room.guides.json"), std::string::npos);
}

TEST_F(GuideSaverTest, WhatCouldNotBeSavedOutlivesAReload) {
  fs::remove_all(folder_);
  edit("a");
  ASSERT_TRUE(update_until([&] { return !document_.messages().shown().empty(); }));
  OpenedScene again = document_.opened();
  document_.open(again);
  saver_->update(now_);
  ASSERT_EQ(document_.guides()->size(), 1u);
  EXPECT_EQ(document_.guides()->front().name, "a");
}

}  // namespace
}  // namespace guidelight

#include "ui/recent_files.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "renderer/error.h"

namespace guidelight {
namespace {

namespace fs = std::filesystem;

class RecentFilesTest : public ::testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  const fs::path folder_ =
      fs::path(::testing::TempDir()) / ("recent_files_" + std::to_string(getpid()));
  const std::string list_ = (folder_ / "state" / "recent").string();
};

TEST_F(RecentFilesTest, KeepsTheNewestFirstAndEachOnce) {
  RecentFiles recent(list_);
  EXPECT_TRUE(recent.paths().empty());
  recent.add("/a.xml");
  recent.add("/b c.xml");
  recent.add("/a.xml");
  EXPECT_EQ(recent.paths(), (std::vector<std::string>{"/a.xml", "/b c.xml"}));
  EXPECT_EQ(RecentFiles(list_).paths(), recent.paths());
}

TEST_F(RecentFilesTest, ForgetsTheOldest) {
  RecentFiles recent(list_);
  for (int i = 0; i < 20; ++i) recent.add(std::to_string(i));
  EXPECT_EQ(recent.paths().size(), RecentFiles::kMostKept);
  EXPECT_EQ(recent.paths().front(), "19");
}

TEST_F(RecentFilesTest, SaysWhyTheListCannotBeWritten) {
  std::ofstream(folder_ / "state") << "a file where the folder should be";
  RecentFiles recent(list_);
  EXPECT_THROW(recent.add("/a.xml"), Error);
}

}  // namespace
}  // namespace guidelight

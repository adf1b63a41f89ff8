#include "ui/numbered_files.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace guidelight {
namespace {

TEST(NumberedFiles, AvoidWhatIsThereAndWhatIsAboutToBe) {
  const std::filesystem::path folder =
      std::filesystem::path(::testing::TempDir()) / "guidelight_numbered_files";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "box-2.png") << "taken";
  NumberedFiles files(folder.string());
  EXPECT_EQ(files.suggest("box", "png"), folder / "box.png");
  EXPECT_EQ(files.next("box", "png"), folder / "box.png");
  EXPECT_EQ(files.next("box", "png"), folder / "box-3.png");
  EXPECT_EQ(files.suggest("box", "png"), folder / "box-4.png");
  EXPECT_EQ(files.next("box", "exr"), folder / "box.exr");
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace guidelight

#include "renderer/io/atomic_file.h"

#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>

#include <csignal>

#include "renderer/error.h"
#include "renderer/io/image_file.h"
#include "tests/renderer/io/io_test_files.h"

namespace guidelight::test {
namespace {

size_t entries(const TemporaryFolder& folder) {
  return static_cast<size_t>(std::distance(std::filesystem::directory_iterator(folder.path()), {}));
}

TEST(AtomicFile, ReplacesTheFileAndLeavesNothingElse) {
  const TemporaryFolder folder;
  const std::string path = folder.write("a.txt", "old");
  write_file_atomically(path, "new bytes");
  EXPECT_EQ(file_bytes(path), "new bytes");
  EXPECT_EQ(entries(folder), 1u);
}

TEST(AtomicFile, KeepsPermissionsAndSymbolicLinks) {
  const TemporaryFolder folder;
  const std::string path = folder.write("real.txt", "old");
  ::chmod(path.c_str(), 0640);
  std::filesystem::create_symlink("real.txt", folder.path() / "link.txt");
  write_file_atomically(folder / "link.txt", "new");
  EXPECT_TRUE(std::filesystem::is_symlink(folder.path() / "link.txt"));
  EXPECT_EQ(file_bytes(path), "new");
  struct stat status;
  ::stat(path.c_str(), &status);
  EXPECT_EQ(status.st_mode & 0777, 0640u);
}

TEST(AtomicFile, AFailedWriterLeavesTheOldFile) {
  const TemporaryFolder folder;
  const std::string path = folder.write("a.txt", "old");
  EXPECT_THROW(write_atomically(path,
                                [](const std::string& temporary) {
                                  std::ofstream(temporary) << "half of";
                                  throw Error("the writer failed");
                                }),
               Error);
  EXPECT_EQ(file_bytes(path), "old");
  EXPECT_EQ(entries(folder), 1u);
}

TEST(AtomicFile, AMissingFolderIsNamed) {
  try {
    write_file_atomically("/no/such/folder/a.txt", "x");
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("/no/such/folder/a.txt"));
    EXPECT_THAT(error.what(), ::testing::HasSubstr("No such file or directory"));
  }
}

TEST(AtomicFile, AFolderIsNotReplaced) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "sub");
  EXPECT_THROW(write_file_atomically(folder / "sub", "x"), Error);
  EXPECT_TRUE(std::filesystem::is_directory(folder.path() / "sub"));
}

TEST(AtomicFile, AFullDeviceIsAnErrorAndStaysADevice) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "there is no /dev/full";
  EXPECT_THROW(write_file_atomically("/dev/full", std::string(1 << 16, 'x')), Error);
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
}

/// A limit on the size of files stands for the full disk: writes fail half-way in the same manner.
template <typename Write>
int exit_code_with_little_space(const Write& write, rlim_t space = 4096) {
  const pid_t child = ::fork();
  if (child == 0) {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{space, space};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    try {
      write();
    } catch (const Error&) {
      ::_exit(7);
    }
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(AtomicFile, AFullDiskNeverDestroysAnExistingPicture) {
  const TemporaryFolder folder;
  const std::string text = folder.write("a.txt", "old");
  const std::string png = folder.write("a.png", "old");
  const std::string exr = folder.write("a.exr", "old");
  DisplayImage display{256, 256, std::vector<uint8_t>(256 * 256 * 4)};
  ImageLayers layers{{{"beauty", Image(256, 256, 3)}}, {}};
  uint32_t noise = 1;  // incompressible
  for (uint8_t& byte : display.rgba)
    byte = static_cast<uint8_t>((noise = noise * 1664525 + 1013904223) >> 24);
  for (float& value : layers.layers[0].second.data()) {
    value = static_cast<float>((noise = noise * 1664525 + 1013904223) >> 8);
  }
  EXPECT_EQ(
      exit_code_with_little_space([&] { write_file_atomically(text, std::string(9999, 'x')); }), 7);
  EXPECT_EQ(exit_code_with_little_space([&] { write_png(png, display); }), 7);
  EXPECT_EQ(exit_code_with_little_space([&] { write_exr(exr, layers); }), 7);
  for (const std::string& path : {text, png, exr}) EXPECT_EQ(file_bytes(path), "old") << path;
  EXPECT_EQ(entries(folder), 3u);
}

/// Small enough for the buffer of a stream, which is written when the file is closed.
TEST(AtomicFile, AFullDiskNeverDestroysASmallPicture) {
  const TemporaryFolder folder;
  const std::string exr = folder.write("a.exr", "old");
  const ImageLayers layers{{{"beauty", Image(4, 4, 3)}}, {}};
  for (const rlim_t space : {0, 200, 300}) {
    EXPECT_EQ(exit_code_with_little_space([&] { write_exr(exr, layers); }, space), 7) << space;
    EXPECT_EQ(file_bytes(exr), "old") << space;
  }
  EXPECT_EQ(entries(folder), 1u);
  write_exr(exr, layers);
  EXPECT_EQ(read_exr(exr).layers.size(), 1u);
}

}  // namespace
}  // namespace guidelight::test

#include "renderer/io/checkpoint_file.h"

#include <gmock/gmock.h>

#include "renderer/error.h"
#include "tests/renderer/io/io_test_files.h"

namespace guidelight::test {
namespace {

TEST(CheckpointFile, ImpossibleFiltersAreErrors) {
  const TemporaryFolder folder;
  const std::string path = folder / "render.checkpoint";
  FilterSettings filter;
  filter.kind = FilterKind::Tent;
  filter.radius = 2;
  Checkpoint checkpoint;
  checkpoint.film = std::make_shared<Film>(2, 1, filter);
  write_checkpoint(path, checkpoint);
  EXPECT_EQ(read_checkpoint(path).film->filter().settings().radius, 2);

  const std::string sound = file_bytes(path);
  for (const auto& [from, to] :
       std::vector<std::pair<std::string, std::string>>{{"\"radius\":2.0", "\"radius\":1e9"},
                                                        {"\"radius\":2.0", "\"radius\":-1"},
                                                        {"\"kind\":1", "\"kind\":4"},
                                                        {"\"kind\":1", "\"kind\":-1"}}) {
    std::string damaged = sound;
    const size_t at = damaged.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    folder.write("render.checkpoint", damaged.replace(at, from.size(), to));
    try {
      read_checkpoint(path);
      ADD_FAILURE() << to << " was accepted";
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), ::testing::HasSubstr("a filter of kind"));
    }
  }
}

}  // namespace
}  // namespace guidelight::test

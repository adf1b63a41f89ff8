#include "renderer/session/open_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "renderer/error.h"
#include "renderer/io/checkpoint_file.h"

namespace guidelight {
namespace {

std::shared_ptr<SceneDescription> open_with_integrator(const std::string& type) {
  const std::string path = std::filesystem::temp_directory_path() /
                           ("guidelight_open_" + std::to_string(getpid()) + ".xml");
  std::ofstream(path) << "<scene version=\"3.0.0\"><integrator type=\"" << type
                      << "\"/><sensor type=\"perspective\"/>"
                         "<shape type=\"sphere\"><emitter type=\"area\"/></shape></scene>";
  auto scene = open_scene(path);
  std::filesystem::remove(path);
  return scene;
}

TEST(OpenScene, warns_of_an_integrator_that_is_not_there) {
  EXPECT_THAT(open_with_integrator("path_sms_ss")->warnings,
              ::testing::ElementsAre(::testing::HasSubstr("'path_sms_ss' is not available")));
  EXPECT_THAT(open_with_integrator("volpath")->warnings, ::testing::IsEmpty());
}

TEST(OpenScene, says_that_another_integrator_of_ours_is_asked_for) {
  EXPECT_THAT(open_with_integrator("bdpt")->warnings,
              ::testing::ElementsAre(::testing::HasSubstr("asks for the integrator 'bdpt'")));
}

TEST(OpenScene, does_not_wait_for_a_pipe) {
  const std::string path = std::filesystem::temp_directory_path() /
                           ("guidelight_pipe_" + std::to_string(getpid()) + ".xml");
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
  ::alarm(10);  // ends the test if it does
  EXPECT_FALSE(is_checkpoint(path));
  EXPECT_THROW(open_scene(path), Error);
  ::alarm(0);
  std::filesystem::remove(path);
}

TEST(OpenScene, direct_light_is_paths_of_two_segments) {
  EXPECT_EQ(open_with_integrator("direct")->hints.max_depth, 2);
  EXPECT_THAT(open_with_integrator("direct")->warnings, ::testing::IsEmpty());
}

}  // namespace
}  // namespace guidelight

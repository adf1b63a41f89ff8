// The program as a script sees it: files, exit status, one line of explanation.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <pty.h>
#include <sys/wait.h>

#include <cstdio>
#include <filesystem>
#include <fstream>

#include "renderer/image/layer.h"
#include "renderer/io/image_file.h"

namespace guidelight {
namespace {

using ::testing::HasSubstr;
namespace fs = std::filesystem;

struct Outcome {
  int status = -1;
  std::string text;  // standard output and error
};

class CommandLine : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("guidelight_cli_" + std::to_string(getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  Outcome run(const std::string& arguments, const std::string& prefix = "") const {
    const std::string command = "cd '" + folder_.string() + "' && " + prefix +
                                " '" GUIDELIGHT_PROGRAM "' " + arguments + " 2>&1";
    Outcome outcome;
    FILE* pipe = popen(command.c_str(), "r");
    for (char buffer[4096]; const size_t count = fread(buffer, 1, sizeof buffer, pipe);) {
      outcome.text.append(buffer, count);
    }
    const int status = pclose(pipe);
    outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return outcome;
  }

  /// Renders a small scene; `arguments` are added.
  Outcome render(const std::string& arguments, const std::string& prefix = "") const {
    return run("render '" + scene() + "' --size 32x24 " + arguments, prefix);
  }

  static std::string scene() { return GUIDELIGHT_SOURCE_DIR "/scenes/cornell/scene.xml"; }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  fs::path folder_;
};

std::vector<float> pixels(const std::string& path) {
  const Image image = read_image(path);
  return {image.data().begin(), image.data().end()};
}

TEST_F(CommandLine, renders_exr_and_png_with_metadata) {
  const Outcome outcome = render("-o a.exr -o a.png --spp 3 --seed 5 --set max_depth=4");
  ASSERT_EQ(outcome.status, 0) << outcome.text;
  const ImageLayers picture = read_exr(path("a.exr"));
  EXPECT_EQ(picture.layers.size(), size_t{kLayerCount});
  for (const std::string& file : {path("a.exr"), path("a.png")}) {
    const Metadata data = read_metadata(file);
    EXPECT_EQ(data.at("passes"), "3");
    EXPECT_EQ(data.at("seed"), "5");
    EXPECT_EQ(data.at("integrator"), "path");
    EXPECT_EQ(data.at("set.max_depth"), "4");
    EXPECT_EQ(data.at("size"), "32x24");
    EXPECT_EQ(data.at("scene"), scene());
    EXPECT_EQ(data.at("scene_hash").size(), 16u);
  }
  EXPECT_EQ(read_image(path("a.png")).width(), 32);
}

TEST_F(CommandLine, settings_may_stand_before_the_scene) {
  const Outcome outcome = run("render --set max_depth=4 --set rr_depth=3 '" + scene() +
                              "' --size 8x8 --spp 1 -o a.exr");
  ASSERT_EQ(outcome.status, 0) << outcome.text;
  const Metadata data = read_metadata(path("a.exr"));
  EXPECT_EQ(data.at("set.max_depth"), "4");
  EXPECT_EQ(data.at("set.rr_depth"), "3");
}

TEST_F(CommandLine, the_same_seed_gives_the_same_picture_on_any_number_of_threads) {
  ASSERT_EQ(render("-o one.exr --float --spp 4 --threads 1").status, 0);
  ASSERT_EQ(render("-o two.exr --float --spp 4 --threads 2").status, 0);
  EXPECT_THAT(pixels(path("two.exr")),
              ::testing::Pointwise(::testing::FloatEq(), pixels(path("one.exr"))));
}

TEST_F(CommandLine, a_crop_holds_the_pixels_of_the_whole) {
  ASSERT_EQ(render("-o whole.exr --float --spp 2").status, 0);
  ASSERT_EQ(render("-o crop.exr --float --spp 2 --crop 5,6,20,18").status, 0);
  const Image whole = read_image(path("whole.exr"));
  const Image crop = read_image(path("crop.exr"));
  ASSERT_EQ(crop.width(), 15);
  ASSERT_EQ(crop.height(), 12);
  EXPECT_EQ(crop.color(3, 4), whole.color(8, 10));
}

TEST_F(CommandLine, a_scene_with_a_crop_window_is_rendered_in_that_size) {
  std::ofstream(path("crop.xml")) << R"(<scene version="3.0.0">
      <sensor type="perspective">
        <film type="hdrfilm">
          <integer name="width" value="48"/> <integer name="height" value="32"/>
          <integer name="crop_offset_x" value="20"/> <integer name="crop_offset_y" value="9"/>
          <integer name="crop_width" value="16"/> <integer name="crop_height" value="12"/>
        </film>
      </sensor>
      <emitter type="constant"/>
    </scene>)";
  const Outcome outcome = run("render crop.xml -o window.exr -o window.png --spp 1");
  ASSERT_EQ(outcome.status, 0) << outcome.text;
  const Image picture = read_image(path("window.exr"));
  ASSERT_EQ(picture.width(), 16);
  ASSERT_EQ(picture.height(), 12);
  EXPECT_THAT(picture.color(15, 11).y, ::testing::FloatEq(picture.color(0, 0).y));
  EXPECT_GT(picture.color(0, 0).y, 0);
}

TEST_F(CommandLine, another_size_keeps_the_place_of_the_crop_window) {
  // The right half of the film sees a lamp, the left half nothing.
  std::ofstream(path("half.xml")) << R"(<scene version="3.0.0">
      <sensor type="perspective">
        <film type="hdrfilm">
          <integer name="width" value="40"/> <integer name="height" value="20"/>
          <integer name="crop_offset_x" value="$x"/>
          <integer name="crop_width" value="20"/> <integer name="crop_height" value="20"/>
        </film>
      </sensor>
      <shape type="rectangle"> <emitter type="area"/>
        <transform name="to_world">
          <scale value="9"/> <rotate y="1" angle="180"/> <translate x="-9.001" z="3"/>
        </transform>
      </shape>
    </scene>)";
  for (const auto& [x, seen] : {std::pair("0", false), std::pair("20", true)}) {
    const Outcome outcome =
        run(std::string("render half.xml -o half.exr --size 8x8 --spp 1 -D x=") + x);
    ASSERT_EQ(outcome.status, 0) << outcome.text;
    const Image picture = read_image(path("half.exr"));
    ASSERT_EQ(picture.width(), 8);
    EXPECT_EQ(picture.color(2, 4).y > 0, seen) << x;
    EXPECT_EQ(picture.color(6, 4).y > 0, seen) << x;
  }
}

TEST_F(CommandLine, stops_by_time_and_by_error) {
  const Outcome timed = render("-o t.exr --time 0.3");
  EXPECT_EQ(timed.status, 0) << timed.text;
  EXPECT_GE(std::stod(read_metadata(path("t.exr")).at("seconds")), 0.3);
  const Outcome converged = render("-o e.exr --error 0.3");
  EXPECT_EQ(converged.status, 0) << converged.text;
  EXPECT_GE(std::stoi(read_metadata(path("e.exr")).at("passes")), 16);
}

TEST_F(CommandLine, an_interrupt_writes_what_is_there) {
  const Outcome outcome = render("-o part.exr --time 60", "timeout --preserve-status -s INT 2");
  EXPECT_EQ(outcome.status, 0) << outcome.text;
  EXPECT_LT(std::stod(read_metadata(path("part.exr")).at("seconds")), 30);
}

TEST_F(CommandLine, a_second_interrupt_ends_it) {
  // The picture goes into a pipe that nobody reads; one that is not ended is killed, as 137.
  const Outcome outcome =
      run("--version", "mkfifo pipe.png; '" GUIDELIGHT_PROGRAM "' render '" + scene() +
                           "' --size 32x24 -o pipe.png --time 60 & p=$!;"
                           "sleep 1; kill -TERM $p; sleep 1; kill -TERM $p;"
                           "(sleep 3; kill -KILL $p) >/dev/null 2>&1 & wait $p; echo =$?;");
  EXPECT_THAT(outcome.text, HasSubstr("=143")) << "128 + SIGTERM";
}

TEST_F(CommandLine, a_checkpoint_that_cannot_be_saved_loses_no_picture) {
  fs::create_directory(folder_ / "gone");
  const Outcome outcome =
      render("-o kept.exr --time 2 --checkpoint gone/state", "{ (sleep 1; rmdir gone) & };");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.text, HasSubstr("gone/state"));
  ASSERT_TRUE(fs::exists(path("kept.exr"))) << outcome.text;
  EXPECT_GE(std::stod(read_metadata(path("kept.exr")).at("seconds")), 2);
}

TEST_F(CommandLine, a_checkpoint_is_resumed_to_the_same_picture) {
  ASSERT_EQ(render("-o whole.exr --float --spp 6").status, 0);
  ASSERT_EQ(render("-o half.exr --spp 3 --checkpoint state").status, 0);
  const Outcome resumed = render("-o resumed.exr --float --spp 6 --checkpoint state --resume");
  ASSERT_EQ(resumed.status, 0) << resumed.text;
  EXPECT_EQ(read_metadata(path("resumed.exr")).at("passes"), "6");
  EXPECT_THAT(pixels(path("resumed.exr")),
              ::testing::Pointwise(::testing::FloatEq(), pixels(path("whole.exr"))));

  const Outcome other = render("-o x.exr --spp 6 --set max_depth=3 --checkpoint state --resume");
  EXPECT_EQ(other.status, 1);
  EXPECT_THAT(other.text, HasSubstr("another"));
}

TEST_F(CommandLine, a_checkpoint_of_an_older_version_is_refused) {
  std::ofstream(path("old")) << R"({"guidelight_checkpoint": 1})"
                             << "\n";
  const Outcome outcome = render("-o x.exr --spp 6 --checkpoint old --resume");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.text, HasSubstr("another version of the program"));
}

TEST_F(CommandLine, merges_parts_with_different_seeds) {
  ASSERT_EQ(render("-o a.exr --spp 2 --seed 1 --checkpoint a").status, 0);
  ASSERT_EQ(render("-o b.exr --spp 4 --seed 2 --checkpoint b").status, 0);
  const Outcome merged = run("merge a b -o both.exr");
  ASSERT_EQ(merged.status, 0) << merged.text;
  EXPECT_EQ(read_metadata(path("both.exr")).at("passes"), "6");
  const Image a = read_image(path("a.exr")), b = read_image(path("b.exr"));
  const Image both = read_image(path("both.exr"));
  for (int c = 0; c < 3; ++c) {
    const float expected = (2 * a.color(9, 9)[c] + 4 * b.color(9, 9)[c]) / 6;
    EXPECT_NEAR(both.color(9, 9)[c], expected, 5e-3f * (expected + 0.1f));  // half floats
  }
  EXPECT_EQ(run("merge a a -o twice.exr").status, 1) << "the same samples twice";
}

TEST_F(CommandLine, compares_pictures) {
  ASSERT_EQ(render("-o a.exr --spp 4 --seed 1").status, 0);
  ASSERT_EQ(render("-o b.exr --spp 4 --seed 2").status, 0);
  const Outcome same = run("compare a.exr a.exr --json");
  EXPECT_EQ(same.status, 0);
  EXPECT_THAT(same.text, HasSubstr("\"relative_mse\":{\"plain\":0.0"));
  EXPECT_EQ(std::count(same.text.begin(), same.text.end(), '\n'), 1);
  const Outcome other = run("compare a.exr b.exr --error-map map.png");
  EXPECT_EQ(other.status, 0);
  EXPECT_THAT(other.text, HasSubstr("relMSE"));
  EXPECT_EQ(read_image(path("map.png")).width(), 32);
}

TEST_F(CommandLine, output_that_cannot_be_written) {
  // Messages may be lost, pictures not, and a list that is asked for only with an error.
  EXPECT_EQ(run("render '" + scene() + "' --size 8x8 --spp 2 -o a.exr 2>&-").status, 0);
  EXPECT_EQ(run("render '" + scene() + "' --size 8x8 --spp 2 -o a.exr 2>/dev/full").status, 0);
  EXPECT_EQ(run("info missing.xml 2>/dev/full").status, 1);
  EXPECT_EQ(run("compare a.exr a.exr --json >/dev/full").status, 1);
  EXPECT_EQ(run("compare a.exr a.exr --json >&- #").status, 1);
  EXPECT_EQ(read_image(path("a.exr")).width(), 8);
}

/// What the program writes to a terminal of this many columns.
std::string on_terminal(unsigned short columns, const std::string& arguments) {
  const winsize size{24, columns, 0, 0};
  int terminal = -1;
  const pid_t child = ::forkpty(&terminal, nullptr, nullptr, &size);
  if (child == 0) {
    ::execl("/bin/sh", "sh", "-c", ("'" GUIDELIGHT_PROGRAM "' " + arguments).c_str(), nullptr);
    ::_exit(127);
  }
  std::string text;
  for (char buffer[4096];;) {
    const ssize_t count = ::read(terminal, buffer, sizeof buffer);
    if (count <= 0) break;  // the terminal ends with the program
    text.append(buffer, static_cast<size_t>(count));
  }
  ::close(terminal);
  ::waitpid(child, nullptr, 0);
  return text;
}

TEST_F(CommandLine, the_progress_bar_keeps_to_one_row) {
  for (const unsigned short columns : {40, 80, 120}) {
    const std::string text = on_terminal(
        columns, "render '" + scene() + "' --size 64x48 --time 0.7 -o '" + path("a.exr") + "'");
    size_t longest = 0;
    const std::string clear = "\r\033[K";
    for (size_t at = text.find(clear); at != std::string::npos;) {
      at += clear.size();
      longest = std::max(longest, std::min(text.find_first_of("\r\n", at), text.size()) - at);
      at = text.find(clear, at);
    }
    EXPECT_GT(longest, 30u) << text;
    EXPECT_LT(longest, columns) << text;
    EXPECT_EQ(text.find('#') != std::string::npos, columns > 40) << text;
  }
}

TEST_F(CommandLine, lists_what_a_scene_holds) {
  const Outcome outcome = run("info '" + scene() + "'");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.text, HasSubstr("triangles"));
  EXPECT_THAT(outcome.text, HasSubstr("lights      1"));
}

TEST_F(CommandLine, says_why_it_failed_in_one_line_with_status_1) {
  std::ofstream(path("broken.xml")) << "<scene version='3.0.0'>\n<shape type='sphere'>\n</scene>\n";
  std::ofstream(path("kept.exr")) << "precious";
  for (const std::string& arguments :
       {std::string("info missing.xml"), std::string("info broken.xml"),
        std::string("render broken.xml -o kept.exr"), std::string("compare kept.exr kept.exr"),
        "render '" + scene() + "' -o no/such/folder/a.exr --time 1000",
        "render '" + scene() + "' -o a.exr --checkpoint no/such/folder/a --time 1000",
        "render '" + scene() +
            "' -o a.exr --integrator bdpt --techniques no/such/a.exr --time 1000"}) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 1) << arguments << "\n" << outcome.text;
    EXPECT_THAT(outcome.text, HasSubstr("guidelight: ")) << arguments;
  }
  EXPECT_THAT(run("info broken.xml").text, HasSubstr("broken.xml:"));
  std::ifstream kept(path("kept.exr"));
  std::string word;
  kept >> word;
  EXPECT_EQ(word, "precious");
}

TEST_F(CommandLine, a_guide_from_nowhere_has_status_1) {
  const std::string trace = "guides trace '" + scene() + "' ";
  for (const std::string way :
       {"--from 0,0,0 --to 0,0,0", "--from nan,0,0 --to 0,0,0", "--from 1e30,0,0 --to 0,0,0",
        "--from 0,0,0 --direction nan,0,0", "--from 0,0,0 --direction inf,0,0"}) {
    EXPECT_EQ(run(trace + way).status, 1) << way;
  }
}

TEST_F(CommandLine, bad_arguments_have_status_2) {
  EXPECT_EQ(run("render").status, 2);
  EXPECT_EQ(run("render '" + scene() + "'").status, 2) << "nothing to write to";
  EXPECT_EQ(render("-o a.exr --spp -3").status, 2);
  EXPECT_EQ(render("-o a.exr --spp 3 --time 3").status, 2);
  EXPECT_EQ(render("-o a.exr --set depth").status, 2);
  EXPECT_EQ(render("-o a.exr --set depth=3").status, 2);
  EXPECT_EQ(render("-o a.exr --integrator magic").status, 2);
  EXPECT_EQ(render("-o a.exr --seed -1").status, 2);
  EXPECT_EQ(render("-o a.exr --crop 0,0,64,64").status, 2);
  EXPECT_EQ(render("-o picture.gif").status, 2);
  EXPECT_EQ(run("render '" + scene() + "' -o a.exr --size 12").status, 2);
  EXPECT_EQ(run("view --size 0x0").status, 2);
  EXPECT_EQ(run("view --size 70000x1").status, 2);
  EXPECT_EQ(run("compare a.exr").status, 2);
  EXPECT_EQ(run("compare a.exr a.exr --error-map map.jpg").status, 2);
  EXPECT_EQ(render("-o a.exr --size 0x9").status, 2);
  EXPECT_EQ(render("-o a.exr --size 70000x9").status, 2);
  EXPECT_EQ(render("-o a.exr --integrator bdpt --techniques t.png --time 99").status, 2);
  EXPECT_EQ(render("-o a.exr --integrator path --techniques t.exr --time 99").status, 2);
  EXPECT_EQ(run("view '" + scene() + "' --integrator magic").status, 2);
  EXPECT_EQ(run("view '" + scene() + "' --threads 5000").status, 2);
  EXPECT_EQ(run("--help").status, 0);
}

}  // namespace
}  // namespace guidelight

// Anything at any time: random clicks, drags, keys, window sizes and scenes while the viewer
// renders. It must live, rest in its memory, and answer at the end.
//
// Lasts GUIDELIGHT_SOAK_SECONDS, or 20 seconds; GUIDELIGHT_VIEWER names another build of the
// viewer, for instance one with sanitizers. tools/soak runs it for ten minutes.

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <random>
#include <thread>

#include "tests/end_to_end/viewer_fixture.h"

namespace guidelight {
namespace {

using namespace std::chrono_literals;
namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

/// Memory is that of the same thing each time: a small paused render of the first scene, after its
/// first passes. The first rounds fill the caches of driver and allocator; of the rest the trend
/// counts, since what is shown beside the picture differs by a few MB from round to round.
constexpr size_t kWarmUpRounds = 4;
constexpr size_t kFewestRounds = 10;
constexpr double kLargestGrowth = 0.02;
constexpr Point kRenderViewAlone{1135, 12};  // a button of the menu bar

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

/// From the first to the last value, along the line whose slope is the median of all pairs' (Theil
/// and Sen): few values that stray do not count.
double trend(const std::vector<double>& values) {
  std::vector<double> slopes;
  for (size_t j = 0; j < values.size(); ++j) {
    for (size_t i = 0; i < j; ++i)
      slopes.push_back((values[j] - values[i]) / static_cast<double>(j - i));
  }
  return median(slopes) * static_cast<double>(values.size() - 1);
}

class SoakTest : public ViewerTest {
 protected:
  /// Scenes of the project in the test's folder, where guides may be saved beside them; and broken
  /// ones.
  void copy_scenes() {
    for (const char* name : {"default", "cornell", "box", "keyhole"}) {
      const fs::path copy = folder() / "scenes" / name;
      fs::create_directories(copy);
      fs::copy(fs::path(scene(name)).parent_path(), copy, fs::copy_options::recursive);
      scenes_.push_back((copy / "scene.xml").string());
    }
    const auto broken = folder() / "broken.xml";
    std::ofstream(broken) << "<scene version='3.0.0'><shape type='obj'></scene>";
    scenes_.push_back(broken.string());
    scenes_.push_back((folder() / "scenes").string());
  }

  /// A small picture of the first scene, whose passes are quick even on a busy machine; its path.
  std::string write_home() const {
    const std::string home = (folder() / "scenes" / "home.exr").string();
    ChildProcess render({GUIDELIGHT_PROGRAM, "render", scenes_.front(), "-o", home, "--size",
                         "160x120", "--spp", "1"},
                        {}, folder().string(), (folder() / "render.txt").string());
    EXPECT_EQ(render.wait(60s), 0);
    return home;
  }

  void act() {
    switch (random(12)) {
      case 0:
      case 1:
        driver_->click(anywhere(), pick<Mouse>({Mouse::Left, Mouse::Left, Mouse::Right}));
        return;
      case 2:
      case 3:
        driver_->click(in_view());
        return;
      case 4:
      case 5:
        drag(in_view());
        return;
      case 6:
        drag(anywhere());
        return;
      case 7:
        driver_->click(anywhere(), pick<Mouse>({Mouse::WheelUp, Mouse::WheelDown}));
        return;
      case 11:
        if (random(10) == 0) driver_->drop_file(pick(scenes_), in_view());
        if (random(10) == 0) driver_->resize_window({700 + random(581), 500 + random(221)});
        return;
      default:
        press();
    }
  }

  /// Back to where all rounds begin and end, by dropping the picture of the first moment. Another
  /// scene comes before it: opening one forgets what was compared with, and goes on if paused.
  void come_back(const std::string& picture) {
    driver_->resize_window({1280, 720});
    for (int i = 0; i < 4; ++i) driver_->press_key("Escape");
    // Clicks are taken one per frame, so that many of them wait on a busy machine.
    ASSERT_TRUE(wait_until([&] { return !save_png().empty(); }, 120s)) << "it does not answer";
    ASSERT_NO_FATAL_FAILURE(drop(scenes_.at(1), "cornell"));
    ASSERT_NO_FATAL_FAILURE(drop(picture, "default"));
    // Whatever the exposure is now.
    ASSERT_TRUE(wait_until([&] { return saved_passes() > 0; }, 60s)) << "nothing is rendered";
  }

  /// [MB] of the viewer at rest, once it has given back what earlier renders used.
  double megabytes_while_paused() {
    driver_->click(kRenderViewAlone);
    driver_->press_key("space");
    std::this_thread::sleep_for(4s);
    const double megabytes = 1e-6 * static_cast<double>(viewer_->resident_bytes());
    driver_->press_key("space");
    return megabytes;
  }

  void remove_pictures() const {
    for (const auto& entry : fs::directory_iterator(folder())) {
      const auto kind = entry.path().extension();
      if (kind == ".png" || kind == ".exr") fs::remove(entry.path());
    }
  }

 private:
  void drop(const std::string& path, const std::string& title) {
    ASSERT_TRUE(wait_until([&] { return driver_->drop_file(path, kViewCenter); }))
        << "the viewer does not take a file any more";
    ASSERT_TRUE(wait_until([&] { return driver_->title().starts_with(title); }))
        << path << " does not come";
  }
  int random(int count) { return std::uniform_int_distribution<int>(0, count - 1)(engine_); }
  template <typename T>
  T pick(const std::vector<T>& list) {
    return list[random(static_cast<int>(list.size()))];
  }
  Point anywhere() { return {random(1280), random(720)}; }
  Point in_view() {
    return {kViewCorner.x + random(kViewSize.x), kViewCorner.y + random(kViewSize.y)};
  }
  std::vector<std::string> modifiers() {
    return pick<std::vector<std::string>>({{}, {}, {"Alt_L"}, {"Shift_L"}, {"Control_L"}});
  }
  void drag(Point from) {
    const Point to{from.x + random(300) - 150, from.y + random(300) - 150};
    driver_->drag(from, to, pick<Mouse>({Mouse::Left, Mouse::Left, Mouse::Middle, Mouse::Right}),
                  modifiers());
  }
  /// Any key of the key table, and digits and letters for fields; but not that which quits.
  void press() {
    static const std::vector<std::string> keys = {
        "g", "g", "k", "Delete", "space",  "BackSpace", "r",           "Tab",
        "p", "v", "f", "Home",   "e",      "n",         "bracketleft", "bracketright",
        "c", "i", "b", "0",      "1",      "F1",        "F2",          "F12",
        "z", "z", "d", "Escape", "Return", "Return",    "w",           "5"};
    driver_->press_key(pick(keys), modifiers());
  }

  std::mt19937 engine_{20261};
  std::vector<std::string> scenes_;
};

TEST_F(SoakTest, LivesThroughAnything) {
  const char* wanted = std::getenv("GUIDELIGHT_SOAK_SECONDS");
  const auto end = Clock::now() + std::chrono::seconds(wanted ? std::atoi(wanted) : 20);
  copy_scenes();
  ASSERT_NO_FATAL_FAILURE(
      start({"--frame-times", (folder() / "scenes/default/scene.xml").string()}));
  ASSERT_TRUE(wait_for_picture());
  const std::string home = write_home();

  std::vector<double> memory;  // [MB] after each round
  size_t actions = 0;
  do {
    const auto end_of_round = std::min(end, Clock::now() + 20s);
    driver_->set_pace(4ms);
    for (; Clock::now() < end_of_round; ++actions) {
      act();
      const auto ended = viewer_->wait(0ms);
      ASSERT_FALSE(ended) << "the viewer ended after " << actions << " actions: " << *ended;
    }
    driver_->set_pace(50ms);
    ASSERT_NO_FATAL_FAILURE(come_back(home));
    memory.push_back(megabytes_while_paused());
    remove_pictures();
  } while (Clock::now() < end);

  EXPECT_FALSE(save_png().empty()) << "the viewer does not answer";
  driver_->press_key("Escape");
  driver_->press_key("q", {"Control_L"});
  EXPECT_EQ(viewer_->wait(20s), 0);
  std::printf("%zu actions; ", actions);
  std::ifstream frames(output());
  std::printf("%s\n", std::string(std::istreambuf_iterator<char>(frames), {}).c_str());
  std::printf("resident after each round [MB]:");
  for (const double megabytes : memory) std::printf(" %.1f", megabytes);
  std::printf("\n");
  if (memory.size() < kWarmUpRounds + kFewestRounds) return;
  const std::vector<double> warm(memory.begin() + kWarmUpRounds, memory.end());
  std::printf("median %.1f MB, trend %+.1f MB\n", median(warm), trend(warm));
  EXPECT_LT(trend(warm), kLargestGrowth * median(warm));
}

}  // namespace
}  // namespace guidelight

#include "tests/end_to_end/viewer_fixture.h"

#include <unistd.h>

#include <algorithm>
#include <fstream>

namespace guidelight {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

constexpr double kBackdrop = 24;  // grey around the picture

}  // namespace

void ViewerTest::SetUp() {
  display_ = VirtualDisplay::start(1280, 720);
  if (!display_) GTEST_SKIP() << "window tests need Xvfb (Debian package xvfb)";
  const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
  folder_ = fs::path(::testing::TempDir()) /
            ("guidelight_" + std::string(info->name()) + "_" + std::to_string(getpid()));
  fs::remove_all(folder_);
  fs::create_directories(folder_);
}

/// After a failure the window is left as a picture beside the test's temporary files.
void ViewerTest::TearDown() {
  if (HasFailure() && driver_) {
    const ScreenPicture screen = capture();
    DisplayImage image{screen.width, screen.height, {}};
    for (const uint32_t pixel : screen.pixels) {
      const auto channel = [&](int shift) { return static_cast<uint8_t>(pixel >> shift & 255); };
      image.rgba.insert(image.rgba.end(), {channel(16), channel(8), channel(0), 255});
    }
    const std::string path = folder_.string() + ".png";
    write_png(path, image);
    std::printf("the window when the test failed: %s\n", path.c_str());
  }
  driver_.reset();
  viewer_.reset();
  display_.reset();
  if (!folder_.empty()) fs::remove_all(folder_);
}

void ViewerTest::start(const std::vector<std::string>& arguments) {
  const char* other = std::getenv("GUIDELIGHT_VIEWER");
  std::vector<std::string> command = {other ? other : GUIDELIGHT_PROGRAM, "view"};
  command.insert(command.end(), arguments.begin(), arguments.end());
  viewer_ = std::make_unique<ChildProcess>(
      command,
      std::vector<std::string>{"DISPLAY=" + display_->name(), "LIBGL_ALWAYS_SOFTWARE=1",
                               "XDG_STATE_HOME=" + (folder_ / "state").string(),
                               "HOME=" + folder_.string(), "XDG_SESSION_TYPE=x11"},
      folder_.string(), output().string());
  driver_ = std::make_unique<X11Driver>(display_->name());
  ASSERT_TRUE(driver_->find_window()) << "no window came";
}

std::string ViewerTest::scene(const std::string& name) {
  return (fs::path(GUIDELIGHT_SOURCE_DIR) / "scenes" / name / "scene.xml").string();
}

bool ViewerTest::wait_for_picture() {
  return wait_until([&] { return view_brightness() > kBackdrop + 4; });
}

bool ViewerTest::wait_for_full_picture() {
  return wait_for_picture() && wait_until([&] { return saved_passes() > 0; });
}

double ViewerTest::view_difference(const ScreenPicture& before) const {
  return block_difference(before, capture(), kViewCorner, kViewSize);
}

double ViewerTest::view_brightness() const {
  return mean_brightness(capture(), {kViewCenter.x - 100, kViewCenter.y - 100}, {200, 200});
}

bool ViewerTest::change_view(const std::function<void()>& act) const {
  constexpr double kMoreThanNoise = 4;
  const ScreenPicture before = capture();
  act();
  return wait_until([&] { return view_difference(before) > kMoreThanNoise; });
}

/// Fields are runs of their colour.
std::vector<Point> ViewerTest::fields_at(int x) const {
  constexpr uint32_t kField = 0x363639;
  constexpr int kLowestHeight = 12;
  const ScreenPicture screen = capture();
  std::vector<Point> fields;
  int begin = 0;
  for (int y = 0; y < screen.height; ++y) {
    if (screen.at({x, y}) == kField) continue;
    if (y - begin > kLowestHeight) fields.push_back({x, (begin + y) / 2});
    begin = y + 1;
  }
  return fields;
}

Point ViewerTest::field_in_left_panel(size_t index) const {
  constexpr int kInside = 290;  // just inside the panel's right edge
  constexpr int kMiddle = 200;
  constexpr size_t kButtons = 1;  // the row of buttons above
  return {kMiddle, fields_at(kInside).at(index + kButtons).y};
}

std::string ViewerTest::save_png() {
  const auto pictures = [&] {
    std::vector<fs::path> found;
    for (const auto& entry : fs::directory_iterator(folder_)) {
      if (entry.path().extension() == ".png") found.push_back(entry.path());
    }
    return found;
  };
  const size_t before = pictures().size();
  const bool saved = wait_until([&] {
    driver_->press_key("F12");  // a key may go to a text field that is about to close
    return wait_until([&] { return pictures().size() > before; }, 2s);
  });
  if (!saved) return "";
  const auto all = pictures();
  return std::ranges::max_element(all, {},
                                  [](const fs::path& path) { return fs::last_write_time(path); })
      ->string();
}

std::string ViewerTest::write_scene(const std::string& name) const {
  const std::string path = (folder_ / name).string();
  std::ofstream(path) << R"(<scene version="3.0.0">
  <sensor type="perspective">
    <transform name="to_world"><lookat origin="0, 0, 5" target="0, 0, 0" up="0, 1, 0"/></transform>
    <film type="hdrfilm"><integer name="width" value="320"/><integer name="height" value="240"/></film>
  </sensor>
  <emitter type="constant"><rgb name="radiance" value="0.4, 0.5, 0.6"/></emitter>
  <shape type="sphere" id="ball"><bsdf type="diffuse" id="chalk"/></shape>
</scene>
)";
  return path;
}

}  // namespace guidelight

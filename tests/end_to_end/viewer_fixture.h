#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <memory>

#include "renderer/io/image_file.h"
#include "tests/end_to_end/x11_driver.h"

namespace guidelight {

/// The colour of an error's stripe, which nothing else has.
inline constexpr uint32_t kErrorStripe = 0xe5534b;

/// Block means that differ less than this are the same view with other noise.
inline constexpr double kNoise = 3;

/// The real program in a real window on a display of its own, 1280×720, with a folder of its own to
/// write to. Tests are skipped without Xvfb.
class ViewerTest : public ::testing::Test {
 protected:
  // Where the view lies between the panels.
  static constexpr Point kViewCorner{309, 27};
  static constexpr Point kViewSize{662, 658};
  static constexpr Point kViewCenter{640, 356};
  static constexpr uint32_t kAccent = 0xe8a84c;  // of what is on or chosen

  void SetUp() override;
  void TearDown() override;

  /// Starts the viewer, or the program that GUIDELIGHT_VIEWER names (another build of it); fails
  /// the test if no window comes.
  void start(const std::vector<std::string>& arguments);
  /// A scene of this project, e.g. "default".
  static std::string scene(const std::string& name);

  /// Waits for a picture in the view: something brighter than the backdrop.
  bool wait_for_picture();
  /// Waits until at least one pass of the full size has been rendered.
  bool wait_for_full_picture();
  ScreenPicture capture() const { return driver_->capture(); }
  /// How different the view looks from an earlier capture, noise apart.
  double view_difference(const ScreenPicture& before) const;
  double view_brightness() const;
  /// Does something that changes the view, a dialog for instance, and waits until it has.
  bool change_view(const std::function<void()>& act) const;

  /// Input fields and buttons that reach a column of the screen, from above.
  std::vector<Point> fields_at(int x) const;
  /// The middle of an input field of the left panel, counted from above, without its buttons.
  Point field_in_left_panel(size_t index) const;

  /// Presses F12 until a file comes; its path. Empty if none comes.
  std::string save_png();
  uint32_t saved_passes() {
    return static_cast<uint32_t>(std::stoul(read_metadata(save_png()).at("passes")));
  }
  std::filesystem::path folder() const { return folder_; }
  /// What the viewer has printed.
  std::filesystem::path output() const { return folder_ / "output.txt"; }
  /// A small scene with a lit ball, in the test's folder.
  std::string write_scene(const std::string& name) const;

  std::unique_ptr<VirtualDisplay> display_;
  std::unique_ptr<ChildProcess> viewer_;
  std::unique_ptr<X11Driver> driver_;

 private:
  std::filesystem::path folder_;
};

}  // namespace guidelight

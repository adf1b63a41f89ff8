#include <thread>

#include "tests/end_to_end/room_fixture.h"

namespace guidelight {
namespace {

using namespace std::chrono_literals;

constexpr uint32_t kMergingFrame = 0x78beff;

class TechniquesTest : public RoomTest {
 protected:
  size_t in_view(uint32_t color) const {
    const ScreenPicture view = driver_->capture_area(kViewCorner, kViewSize);
    return count_color(view, color);
  }
  void record_and_show() const {
    driver_->press_key("t", {"Shift_L"});
    driver_->press_key("t");
  }
};

TEST_F(TechniquesTest, ThePyramidMarksMergingOnesAndAClickEnlargesOne) {
  open_room({"--integrator", "vcm"});
  record_and_show();
  // The paused render finishes a pass for it; the frames of merging ones are seen.
  ASSERT_TRUE(wait_until([&] { return in_view(kMergingFrame) > 1000; }));

  // Light that is seen directly: the only one of its length, at the upper left.
  const Point first{kViewCorner.x + 130, kViewCorner.y + 100};
  driver_->move_mouse(first);
  EXPECT_TRUE(wait_until([&] { return in_view(kAccent) > 200; }));  // its frame
  driver_->click(first);
  EXPECT_TRUE(wait_until([&] { return in_view(kMergingFrame) == 0; }));
  // Nothing but the lamp is lit by it.
  const Point lamp = in_picture(lamp_front());
  const Point floor = in_picture(kFloor);
  EXPECT_TRUE(wait_until([&] {
    const ScreenPicture screen = capture();
    return screen.at(lamp) == 0xffffff && screen.at(floor) == 0x000000;
  }));

  driver_->press_key("Escape");
  EXPECT_TRUE(wait_until([&] { return in_view(kMergingFrame) > 1000; }));
  driver_->press_key("Escape");
  EXPECT_TRUE(
      wait_until([&] { return in_view(kMergingFrame) == 0 && capture().at(floor) != 0x000000; }));
}

TEST_F(TechniquesTest, AreNotShownWhereTheyAreNotRecordedOrThereAreNone) {
  // Without a picture in its middle the view is as dark as what lies around pictures.
  constexpr double kDark = 28;
  open_room({"--integrator", "vcm"});
  driver_->press_key("t");  // not recorded
  std::this_thread::sleep_for(500ms);
  EXPECT_GT(view_brightness(), kDark);
  EXPECT_EQ(in_view(kMergingFrame), 0u);
  record_and_show();
  EXPECT_TRUE(wait_until([&] { return in_view(kMergingFrame) > 1000; }));
  viewer_.reset();

  open_room({"--integrator", "path"});
  record_and_show();
  std::this_thread::sleep_for(500ms);
  EXPECT_GT(view_brightness(), kDark);
}

}  // namespace
}  // namespace guidelight

#include "tests/end_to_end/room_fixture.h"

namespace guidelight {
namespace {

class InspectorTest : public RoomTest {};

TEST_F(InspectorTest, BarsShowWhatAPickedPixelsLightIsMadeOf) {
  open_room();
  constexpr uint32_t kFilled = 0x755e40;  // of a bar, and of the exposure slider
  driver_->move_mouse({kViewCenter.x, kViewCorner.y + 5});
  EXPECT_TRUE(wait_until([&] { return count_color(capture(), kFilled) < 500; }));
  driver_->click(in_picture(kFloor));
  // Light that is direct, and found by connecting paths: two bars of 180 pixels by 15 at most.
  EXPECT_TRUE(wait_until([&] { return count_color(capture(), kFilled) > 2000; }));
}

}  // namespace
}  // namespace guidelight

#include <cmath>
#include <thread>

#include "renderer/image/tonemap.h"
#include "tests/end_to_end/room_fixture.h"

namespace guidelight {
namespace {

using namespace std::chrono_literals;

uint32_t on_screen_color(Color display) {
  const glm::uvec3 bytes(glm::round(255.0f * display));
  return bytes.x << 16 | bytes.y << 8 | bytes.z;
}

class PhotonsTest : public RoomTest {
 protected:
  void show_photons(const std::string& integrator) {
    open_room({"--integrator", integrator, "--size", "64x48"});
    driver_->press_key("space");  // photons come with the next pass
    driver_->press_key("p");
    ASSERT_TRUE(wait_until([&] { return bars_of_powers() > 200; })) << "the panel's histogram";
  }
  /// Pixels of the histogram's bars. Looking for its colours, and not for a change of the picture,
  /// tells photons from the noise of a first pass.
  size_t bars_of_powers() const {
    constexpr int kBars = 48;
    const ScreenPicture screen = capture();
    size_t count = 0;
    for (int bar = 0; bar < kBars; ++bar) {
      const float power = (static_cast<float>(bar) + 0.5f) / kBars;
      count += count_color(screen, on_screen_color(color_map(ColorMap::Turbo, power)));
    }
    return count;
  }
  /// The fields of the Photons tab that are not lit, from above: "Density", the colours, …
  Point field(size_t index) const { return fields_at(kInPanel).at(index); }

  static constexpr int kInPanel = 1262;  // just inside the right panel's right edge
};

TEST_F(PhotonsTest, TheirDensityIsShownInBothViewsWithItsScale) {
  show_photons("sppm");
  const Point density = field(0);
  driver_->click(density);
  const uint32_t densest = on_screen_color(color_map(ColorMap::Viridis, 127.0f / 128));
  const auto scale_shown = [&] { return count_color(capture(), densest) > 20; };
  EXPECT_TRUE(wait_until(scale_shown)) << "in the picture";
  driver_->press_key("Tab");
  EXPECT_TRUE(wait_until(scale_shown)) << "in the scout view";
  driver_->click(density);
  EXPECT_TRUE(wait_until([&] { return !scale_shown(); }));
}

TEST_F(PhotonsTest, GuidedOnesHaveTheColourOfTheirGuide) {
  show_photons("sppm");
  place({in_picture(lamp_front()), in_picture(kFloor)});
  driver_->press_key("Return");
  ASSERT_TRUE(wait_for_guides(1));
  const uint32_t color = on_screen_color(saved_guides().front().color);
  driver_->press_key("Escape");
  driver_->press_key("g", {"Shift_L"});  // hides the guide itself
  driver_->press_key("p");
  driver_->press_key("p");  // the tab comes back
  ASSERT_TRUE(wait_until([&] { return fields_at(kInPanel).size() >= 4; }));
  EXPECT_LT(count_color(capture(), color), 100u);
  const Point colors = field(1);
  driver_->click(colors);
  std::this_thread::sleep_for(500ms);
  driver_->click({colors.x - 100, colors.y + 95});  // the fourth choice
  EXPECT_TRUE(wait_until([&] { return count_color(capture(), color) > 300; }));
}

TEST_F(PhotonsTest, ADiscUnderTheMouseShowsWhatAnEstimateIsMadeOf) {
  show_photons("photon_map");
  const Point at = in_picture(kFloor);
  driver_->move_mouse({kViewCenter.x, kViewCorner.y + 5});
  driver_->press_key("space");
  const ScreenPicture before = driver_->capture_when_still();
  driver_->move_mouse(at);
  // Its words stand on a dark ground to the lower right of the mouse.
  EXPECT_TRUE(wait_until([&] {
    return block_difference(before, capture(), {at.x + 16, at.y + 8}, {128, 32}) > 10;
  }));
}

}  // namespace
}  // namespace guidelight

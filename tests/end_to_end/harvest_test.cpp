#include <cmath>

#include "tests/end_to_end/room_fixture.h"

namespace guidelight {
namespace {

using namespace std::chrono_literals;

class HarvestTest : public RoomTest {
 protected:
  /// Presses K until the search has found something to keep; on a busy machine that may keep it
  /// more than once.
  bool keep_strongest() {
    return wait_until([&] {
      driver_->press_key("k");
      return wait_until([&] { return !saved_guides().empty(); }, 2s);
    });
  }

  void expect_from_the_lamp(const GuidePath& guide) const {
    expect_usable(guide);
    EXPECT_NEAR(glm::distance(guide.vertices.front().position, kLamp), 0.25f, 1e-3f);
  }
};

TEST_F(HarvestTest, ThePickedPixelsStrongestPathIsKeptByK) {
  open_room();
  // H opens the Guides tab; Escape leaves it open and puts the tool aside.
  driver_->press_key("h");
  driver_->press_key("Escape");
  driver_->press_key("k");  // nothing is picked yet
  driver_->click(in_picture(kFloor));
  ASSERT_TRUE(keep_strongest());
  const GuidePath guide = saved_guides().front();
  expect_from_the_lamp(guide);
  const Point picked = in_picture(kFloor);
  const Point end = in_picture(guide.vertices.back().position);
  EXPECT_LT(std::hypot(end.x - picked.x, end.y - picked.y), 5) << "it leads to what was clicked";

  EXPECT_TRUE(wait_until([&] {
    driver_->press_key("z", {"Control_L"});
    return wait_until([&] { return saved_guides().empty(); }, 2s);
  }));
}

TEST_F(HarvestTest, ADraggedRectangleIsHarvested) {
  open_room();
  driver_->press_key("h");
  const Point low = in_picture(kWall + Vec3(-0.4f, 0.3f, 0));
  const Point high = in_picture(kWall + Vec3(0.4f, -0.3f, 0));
  driver_->drag(low, high, Mouse::Left);
  constexpr uint32_t kOutline = 0xe8a84c;
  EXPECT_TRUE(wait_until([&] { return count_color(capture(), kOutline) > 200; }))
      << "the rectangle stays";
  ASSERT_TRUE(keep_strongest());
  const GuidePath guide = saved_guides().front();
  expect_from_the_lamp(guide);
  const Point end = in_picture(guide.vertices.back().position);
  EXPECT_GE(end.x, low.x - 3);
  EXPECT_LE(end.x, high.x + 3);
  EXPECT_GE(end.y, low.y - 3);
  EXPECT_LE(end.y, high.y + 3);
}

TEST_F(HarvestTest, WhatIsFoundIsBroughtIntoSightBelowALongList) {
  const std::vector<GuidePath> guides(16, {.name = "far", .vertices = {{kLamp}, {kFloor}}});
  write_guides((folder() / "room.guides.json").string(), guides);
  open_room();
  driver_->press_key("h");
  driver_->press_key("Escape");
  const Point corner{980, 70};
  const Point size{285, 600};
  const ScreenPicture before = driver_->capture_when_still();
  driver_->click(in_picture(kWall));  // away from the guides, whose vertices would be grabbed
  EXPECT_TRUE(wait_until([&] { return block_difference(before, capture(), corner, size) > 3; }))
      << "the panel scrolls";
}

}  // namespace
}  // namespace guidelight

#include <thread>

#include "tests/end_to_end/room_fixture.h"

namespace guidelight {
namespace {

using namespace std::chrono_literals;

class GuideTest : public RoomTest {};

void expect_near(Vec3 a, Vec3 b, float tolerance) { EXPECT_LT(glm::distance(a, b), tolerance); }

TEST_F(GuideTest, APathIsPlacedInThePictureUndoneAndDoneAgain) {
  open_room();
  place({in_picture(lamp_front()), in_picture(kFloor), in_picture(kWall)});
  driver_->press_key("Return");
  ASSERT_TRUE(wait_for_guides(1));
  const GuidePath guide = saved_guides().front();
  ASSERT_EQ(guide.vertices.size(), 3u);
  expect_near(guide.vertices[0].position, lamp_front(), 0.05f);
  expect_near(guide.vertices[1].position, kFloor, 0.1f);
  expect_near(guide.vertices[2].position, kWall, 0.1f);
  expect_usable(guide);

  driver_->press_key("z", {"Control_L"});
  EXPECT_TRUE(wait_for_guides(0));
  driver_->press_key("z", {"Control_L", "Shift_L"});
  EXPECT_TRUE(wait_for_guides(1));
}

TEST_F(GuideTest, BackspaceTakesBackAndEscapeCancels) {
  open_room();
  place({in_picture(lamp_front()), in_picture(kFloor), in_picture(kWall)});
  driver_->press_key("BackSpace");
  driver_->press_key("Return");
  ASSERT_TRUE(wait_for_guides(1));
  EXPECT_EQ(saved_guides().front().vertices.size(), 2u);
  driver_->click(in_picture(lamp_front()));
  std::this_thread::sleep_for(450ms);
  driver_->press_key("Escape");  // the path
  driver_->press_key("Escape");  // the tool
  driver_->press_key("Return");
  std::this_thread::sleep_for(1s);
  EXPECT_EQ(saved_guides().size(), 1u);
}

TEST_F(GuideTest, MirrorsAreFollowedInTheScoutView) {
  open_room();
  ASSERT_TRUE(change_view([&] { driver_->press_key("Tab"); }));
  place({in_scout(lamp_front()), in_scout(kMirror)});
  driver_->press_key("Return");
  ASSERT_TRUE(wait_for_guides(1));
  const GuidePath guide = saved_guides().front();
  ASSERT_EQ(guide.vertices.size(), 3u) << "the light, the mirror and what it shows";
  EXPECT_EQ(guide.vertices[1].event, PathEvent::Reflect);
  expect_near(guide.vertices[1].position, kMirror, 0.1f);
  expect_usable(guide);
}

TEST_F(GuideTest, ADraggedVertexTakesThePathAlongAndOneStepUndoesTheDrag) {
  open_room();
  place({in_picture(lamp_front()), in_picture(kFloor), in_picture(kWall)});
  driver_->press_key("Return");
  ASSERT_TRUE(wait_for_guides(1));
  driver_->press_key("Escape");
  const Vec3 elsewhere(0.6f, 0, 0.3f);
  driver_->drag(in_picture(kFloor), in_picture(elsewhere), Mouse::Left);
  const auto moved = [&] {
    const auto guides = saved_guides();
    return !guides.empty() && glm::distance(guides[0].vertices.at(1).position, elsewhere) < 0.15f;
  };
  ASSERT_TRUE(wait_until(moved, 5s));
  expect_usable(saved_guides().front());
  expect_near(saved_guides().front().vertices[2].position, kWall, 0.1f);
  driver_->press_key("z", {"Control_L"});
  EXPECT_TRUE(wait_until([&] { return !moved(); }, 5s));
  expect_near(saved_guides().front().vertices[1].position, kFloor, 0.1f);
}

TEST_F(GuideTest, DraggingFromTheLightSwingsAWholePath) {
  open_room();
  driver_->press_key("g");
  const Vec3 before_the_mirror(0.9f, 0, 1.2f);
  driver_->drag(in_picture(lamp_front()), in_picture(before_the_mirror), Mouse::Left);
  driver_->press_key("Return");
  ASSERT_TRUE(wait_for_guides(1));
  const GuidePath guide = saved_guides().front();
  EXPECT_GE(guide.vertices.size(), 2u);
  expect_near(guide.vertices[1].position, before_the_mirror, 0.1f);
  expect_usable(guide);
}

TEST_F(GuideTest, ADroppedPictureBringsItsGuidesBack) {
  open_room();
  driver_->press_key("space");
  place({in_picture(lamp_front()), in_picture(kFloor)});
  driver_->press_key("Return");
  ASSERT_TRUE(wait_for_guides(1));
  const std::string picture = save_png();
  ASSERT_FALSE(picture.empty());
  driver_->press_key("Delete");
  ASSERT_TRUE(wait_for_guides(0));
  ASSERT_TRUE(driver_->drop_file(picture, kViewCenter));
  ASSERT_TRUE(wait_for_guides(1));
  expect_usable(saved_guides().front());
}

}  // namespace
}  // namespace guidelight

#include <thread>

#include "tests/end_to_end/viewer_fixture.h"

namespace guidelight {
namespace {

using namespace std::chrono_literals;

class ViewsTest : public ViewerTest {
 protected:
  void press_and_settle(const char* key) {
    driver_->press_key(key);
    std::this_thread::sleep_for(600ms);
  }
};

TEST_F(ViewsTest, TheScoutViewHasItsOwnCameraAndDoesNotMoveTheRenderCamera) {
  start({write_scene("ball.xml")});
  ASSERT_TRUE(wait_for_full_picture());
  const std::string camera = read_metadata(save_png()).at("camera_to_world");
  ASSERT_TRUE(change_view([&] { driver_->press_key("Tab"); }));
  EXPECT_TRUE(change_view([&] {
    driver_->drag(kViewCenter, {kViewCenter.x + 120, kViewCenter.y + 90}, Mouse::Middle,
                  {"Shift_L"});
  })) << "the ball moves with the mouse";
  EXPECT_TRUE(change_view([&] { driver_->press_key("Home"); })) << "back to the render camera";
  EXPECT_EQ(read_metadata(save_png()).at("camera_to_world"), camera);
}

TEST_F(ViewsTest, TheScoutViewShowsTheSceneInThreeWays) {
  start({write_scene("ball.xml")});
  ASSERT_TRUE(wait_for_picture());
  press_and_settle("space");
  ASSERT_TRUE(change_view([&] { driver_->press_key("Tab"); }));
  EXPECT_TRUE(change_view([&] { driver_->click({409, 44}); })) << "wires";
  EXPECT_TRUE(change_view([&] { driver_->click({485, 44}); })) << "see-through";
}

// Fields of the left panel reach that column only where the interface is larger than usual.
TEST_F(ViewsTest, TheInterfaceHasTheScaleOfTheMonitor) {
  constexpr int kBeyondUsualPanel = 400;
  announce_dpi(display_->name(), 144);
  start({write_scene("ball.xml")});
  ASSERT_TRUE(wait_for_picture());
  EXPECT_TRUE(wait_until([&] { return fields_at(kBeyondUsualPanel).size() >= 5; }));
}

TEST_F(ViewsTest, TheScaleOfTheCommandLineGoesBeforeThatOfTheMonitor) {
  constexpr int kInUsualPanel = 290;
  constexpr int kBeyondUsualPanel = 400;
  announce_dpi(display_->name(), 144);
  start({"--ui-scale", "1", write_scene("ball.xml")});
  ASSERT_TRUE(wait_for_picture());
  EXPECT_TRUE(wait_until([&] { return fields_at(kInUsualPanel).size() >= 5; }));
  EXPECT_TRUE(fields_at(kBeyondUsualPanel).empty());
}

TEST_F(ViewsTest, EscapeClosesAListAndNothingElse) {
  start({write_scene("ball.xml")});
  ASSERT_TRUE(wait_for_full_picture());
  press_and_settle("space");
  const ScreenPicture before = driver_->capture_when_still();
  driver_->click(field_in_left_panel(0));
  const auto list_shown = [&] {
    return block_difference(before, capture(), {20, 240}, {260, 280}) > kNoise;
  };
  EXPECT_TRUE(wait_until(list_shown)) << "the algorithms";
  driver_->press_key("Escape");
  EXPECT_TRUE(wait_until([&] { return !list_shown(); }));
}

TEST_F(ViewsTest, APreviewIsNotExported) {
  // Too large for a pass to be done while the test looks.
  start({scene("default"), "--size", "1600x1600", "--integrator", "bdpt"});
  ASSERT_TRUE(wait_for_picture());
  const auto exported = [&] { return std::filesystem::exists(folder() / "default.exr"); };
  driver_->press_key("e", {"Control_L"});
  EXPECT_FALSE(wait_until(exported, 3s));
}

TEST_F(ViewsTest, PhotonsAreDrawnOverTheScene) {
  start({scene("cornell"), "--integrator", "sppm", "--size", "64x64"});
  ASSERT_TRUE(wait_for_full_picture());
  press_and_settle("Tab");
  const ScreenPicture before = capture();
  driver_->press_key("p");
  EXPECT_TRUE(wait_until([&] { return view_difference(before) > kNoise; }));
  driver_->press_key("p");
  EXPECT_TRUE(wait_until([&] { return view_difference(before) < 1; }));
}

TEST_F(ViewsTest, APinnedPictureIsWipedOverTheRenderAndShownAloneWithShift) {
  start({write_scene("ball.xml")});
  ASSERT_TRUE(wait_for_full_picture());
  driver_->press_key("b");
  std::this_thread::sleep_for(1s);
  // The render then shows the ball elsewhere.
  ASSERT_TRUE(change_view([&] {
    driver_->drag(kViewCenter, {kViewCenter.x + 150, kViewCenter.y}, Mouse::Middle, {"Alt_L"});
  }));
  driver_->move_mouse({kViewCenter.x + 40, kViewCenter.y + 40});
  EXPECT_TRUE(change_view([&] { driver_->hold_key("Shift_L", true); }));
  EXPECT_TRUE(change_view([&] { driver_->hold_key("Shift_L", false); }));
}

TEST_F(ViewsTest, RenderSettingsUndoAndRedo) {
  start({write_scene("ball.xml")});
  ASSERT_TRUE(wait_for_full_picture());
  driver_->press_key("r");
  driver_->drag({kViewCenter.x - 100, kViewCenter.y - 80},
                {kViewCenter.x + 100, kViewCenter.y + 80}, Mouse::Left);
  const auto has_region = [&] { return read_metadata(save_png()).contains("region"); };
  EXPECT_TRUE(wait_until(has_region));
  driver_->press_key("z", {"Control_L"});
  EXPECT_TRUE(wait_until([&] { return !has_region(); }));
  driver_->press_key("z", {"Control_L", "Shift_L"});
  EXPECT_TRUE(wait_until(has_region));
}

}  // namespace
}  // namespace guidelight

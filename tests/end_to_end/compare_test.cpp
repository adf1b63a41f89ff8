#include <cmath>
#include <thread>

#include "tests/end_to_end/viewer_fixture.h"

namespace guidelight {
namespace {

using namespace std::chrono_literals;

/// Whether a colour is that of the present render's curves, give or take the smoothing of edges.
bool is_curve(uint32_t color) {
  constexpr int kCurve[] = {0xe8, 0xa8, 0x4c};
  int largest = 0;
  for (int channel = 0; channel < 3; ++channel) {
    const int value = static_cast<int>(color >> (16 - 8 * channel) & 255);
    largest = std::max(largest, std::abs(value - kCurve[channel]));
  }
  return largest < 24;
}

class CompareTest : public ViewerTest {
 protected:
  /// Columns of the right panel in which a curve can be seen.
  size_t columns_with_curve() const {
    const ScreenPicture screen = capture();
    size_t columns = 0;
    for (int x = kViewCorner.x + kViewSize.x; x < screen.width; ++x) {
      bool found = false;
      for (int y = kViewCorner.y; y < screen.height && !found; ++y)
        found = is_curve(screen.at({x, y}));
      columns += found ? 1 : 0;
    }
    return columns;
  }

  /// By the dialog.
  void load_reference(const std::string& name) {
    ASSERT_TRUE(change_view([&] { driver_->press_key("l", {"Control_L"}); }));
    driver_->press_key("End");
    driver_->type(name + "\n");
    std::this_thread::sleep_for(1s);  // for the dialog to leave the screen
  }
};

TEST_F(CompareTest, AReferenceGivesTheErrorOverTime) {
  start({write_scene("ball.xml")});
  ASSERT_TRUE(wait_for_full_picture());
  driver_->press_key("e", {"Control_L", "Shift_L"});
  ASSERT_TRUE(wait_until([&] { return std::filesystem::exists(folder() / "ball.exr"); }));
  EXPECT_LT(columns_with_curve(), 150u);
  load_reference("ball.exr");
  // Both plots span the panel once there are two measurements.
  EXPECT_TRUE(wait_until([&] { return columns_with_curve() > 150; }));
}

TEST_F(CompareTest, ADroppedPictureWithoutASessionIsTakenAsTheReference) {
  start({write_scene("ball.xml")});
  ASSERT_TRUE(wait_for_full_picture());
  const std::string path = (folder() / "plain.exr").string();
  write_exr(path, {{{"beauty", read_image(save_png())}}, {}});
  EXPECT_LT(columns_with_curve(), 150u);
  ASSERT_TRUE(driver_->drop_file(path, kViewCenter));
  EXPECT_TRUE(wait_until([&] { return columns_with_curve() > 150; }));
}

TEST_F(CompareTest, ADroppedPictureWithASessionCanBecomeTheReference) {
  start({write_scene("ball.xml")});
  ASSERT_TRUE(wait_for_full_picture());
  const std::string saved = save_png();
  ASSERT_TRUE(driver_->drop_file(saved, kViewCenter));
  // The message's button, at its left.
  constexpr int kInButton = kViewCorner.x + 40;
  ASSERT_TRUE(wait_until([&] { return !fields_at(kInButton).empty(); }));
  EXPECT_LT(columns_with_curve(), 150u);
  driver_->click(fields_at(kInButton).front());
  EXPECT_TRUE(wait_until([&] { return columns_with_curve() > 150; }));
}

TEST_F(CompareTest, AFileThatIsNoPictureIsRefusedInWords) {
  const std::string scene = write_scene("ball.xml");
  start({scene});
  ASSERT_TRUE(wait_for_picture());
  load_reference("ball.xml");
  EXPECT_TRUE(wait_until([&] { return count_color(capture(), kErrorStripe) > 40; }));
}

}  // namespace
}  // namespace guidelight

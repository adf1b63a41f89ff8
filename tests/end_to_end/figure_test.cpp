#include "renderer/io/spectrum.h"
#include "tests/end_to_end/room_fixture.h"

namespace guidelight {
namespace {

using namespace std::chrono_literals;

class FigureTest : public RoomTest {};

TEST_F(FigureTest, ShowsThePictureWithItsGuidesAndALegend) {
  open_room();
  place({in_picture(lamp_front()), in_picture(kFloor), in_picture(kWall)});
  driver_->press_key("Return");
  ASSERT_TRUE(wait_for_guides(1));
  driver_->press_key("F12", {"Control_L"});
  const auto path = folder() / "room-figure.png";
  ASSERT_TRUE(wait_until([&] { return std::filesystem::exists(path); }));
  const Image figure = read_image(path.string());
  constexpr int kEnlarged = 4;  // 320 × 240 to 1280 × 960
  EXPECT_EQ(figure.width(), kEnlarged * 320);
  EXPECT_GT(figure.height(), kEnlarged * 240) << "the legend is below";

  const GuidePath guide = saved_guides().front();
  const Color wanted = srgb_to_linear(guide.color);
  for (const GuideVertex& vertex : guide.vertices) {
    const auto seen = scene_->camera().connect(vertex.position, Vec2(0.5f));
    const glm::ivec2 at(glm::floor(seen->raster * float{kEnlarged}));
    EXPECT_LT(glm::length(figure.color(at.x, at.y) - wanted), 0.05f) << "a mark at each vertex";
  }
  int in_legend = 0;
  for (int y = kEnlarged * 240; y < figure.height(); ++y) {
    for (int x = 0; x < figure.width(); ++x) {
      in_legend += glm::length(figure.color(x, y) - wanted) < 0.05f ? 1 : 0;
    }
  }
  EXPECT_GT(in_legend, 50) << "its colour is explained";
  EXPECT_TRUE(read_metadata(path.string()).contains("guides")) << "dropped, it brings them back";
}

}  // namespace
}  // namespace guidelight

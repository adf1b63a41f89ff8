#include "ui/view_transform.h"

#include <gtest/gtest.h>

namespace guidelight {
namespace {

TEST(ViewTransform, FitsThePictureIntoTheMiddleOfTheRoom) {
  ViewTransform transform;
  transform.set_room({100, 50}, {800, 400}, {400, 400});
  EXPECT_FLOAT_EQ(transform.scale(), 1);
  EXPECT_EQ(transform.to_screen({0, 0}), Vec2(300, 50));
  EXPECT_EQ(transform.to_screen({400, 400}), Vec2(700, 450));
}

TEST(ViewTransform, GoesThereAndBack) {
  ViewTransform transform;
  transform.set_room({10, 20}, {640, 480}, {1000, 700});
  transform.zoom_about({200, 100}, 3.3f);
  const Vec2 pixel = transform.to_pixel(transform.to_screen({123.4f, 56.7f}));
  EXPECT_NEAR(pixel.x, 123.4f, 1e-3f);
  EXPECT_NEAR(pixel.y, 56.7f, 1e-3f);
}

TEST(ViewTransform, ZoomKeepsThePixelUnderTheMouse) {
  ViewTransform transform;
  transform.set_room({0, 0}, {600, 600}, {600, 600});
  const Vec2 mouse(420, 130);
  const Vec2 before = transform.to_pixel(mouse);
  for (int i = 0; i < 10; ++i) transform.zoom_about(mouse, 1.25f);
  const Vec2 after = transform.to_pixel(mouse);
  EXPECT_NEAR(before.x, after.x, 1);  // the picture lies on whole screen pixels
  EXPECT_NEAR(before.y, after.y, 1);
  EXPECT_NEAR(transform.scale(), std::pow(1.25f, 10), 1e-3f);
  EXPECT_FALSE(transform.fitted());
}

TEST(ViewTransform, ActualPixelsLieOnScreenPixels) {
  ViewTransform transform;
  transform.set_room({0, 26}, {701, 653}, {320, 200});
  transform.zoom_to(1);
  const Vec2 corner = transform.to_screen({0, 0});
  EXPECT_EQ(corner, glm::round(corner));
  EXPECT_EQ(transform.to_screen({320, 200}) - corner, Vec2(320, 200));
}

TEST(ViewTransform, AZoomSurvivesAResizedWindowAndAFitFollowsIt) {
  ViewTransform transform;
  transform.set_room({0, 0}, {500, 500}, {100, 100});
  transform.set_room({0, 0}, {300, 500}, {100, 100});
  EXPECT_FLOAT_EQ(transform.scale(), 3);
  transform.zoom_to(2);
  transform.set_room({0, 0}, {700, 700}, {100, 100});
  EXPECT_FLOAT_EQ(transform.scale(), 2);
  EXPECT_EQ(transform.to_screen({50, 50}), Vec2(350, 350));
}

TEST(ViewTransform, StaysWithinItsLimits) {
  ViewTransform transform;
  transform.set_room({0, 0}, {500, 500}, {100, 100});
  transform.zoom_about({250, 250}, 1e9f);
  EXPECT_FLOAT_EQ(transform.scale(), ViewTransform::kMaxScale);
  transform.zoom_about({250, 250}, 1e-9f);
  EXPECT_FLOAT_EQ(transform.scale(), ViewTransform::kMinScale);
  transform.move({1e6f, 1e6f});
  EXPECT_EQ(transform.to_pixel({250, 250}), Vec2(0, 0)) << "the picture cannot be lost";
}

}  // namespace
}  // namespace guidelight

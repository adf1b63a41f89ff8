#include "ui/tools/region_tool.h"

#include <gtest/gtest.h>

namespace guidelight {
namespace {

TEST(RegionTool, TakesWholePixelsInAnyDirectionOfTheDrag) {
  const auto region = region_between({10.7f, 20.2f}, {3.1f, 5.9f}, 100, 100);
  ASSERT_TRUE(region);
  EXPECT_EQ(region->x0, 3);
  EXPECT_EQ(region->y0, 5);
  EXPECT_EQ(region->x1, 11);
  EXPECT_EQ(region->y1, 21);
}

TEST(RegionTool, StaysWithinThePicture) {
  const auto region = region_between({-50, -50}, {30, 1000}, 100, 80);
  ASSERT_TRUE(region);
  EXPECT_EQ(region->x0, 0);
  EXPECT_EQ(region->y0, 0);
  EXPECT_EQ(region->x1, 30);
  EXPECT_EQ(region->y1, 80);
  EXPECT_FALSE(region_between({-50, -50}, {-10, -10}, 100, 80)) << "outside";
}

TEST(RegionTool, ADragSetsTheRegionAndAClickClearsIt) {
  Document document([] {});
  RenderSettings settings;
  settings.width = 100;
  settings.height = 100;
  document.set_settings(settings);
  ViewTransform transform;
  transform.set_room({0, 0}, {100, 100}, {100, 100});
  const ViewProjection projection(Camera({}, {}), {0, 0}, 1, 0.1f, 10);
  const auto at = [&](Vec2 mouse) { return ToolView{projection, &transform, {}, false, mouse}; };
  RegionTool tool;
  tool.press(document, at({10, 10}));
  tool.drag(document, at({30, 20}));
  EXPECT_FALSE(tool.finished());
  tool.release(document, at({40, 50}));
  EXPECT_TRUE(tool.finished());
  ASSERT_TRUE(document.settings().region);
  EXPECT_EQ(document.settings().region->x1, 40);
  tool.press(document, at({10, 10}));
  tool.release(document, at({10, 10}));
  EXPECT_FALSE(document.settings().region);
}

}  // namespace
}  // namespace guidelight

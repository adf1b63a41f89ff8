#include "ui/tools/rectangle_tool.h"

#include <gtest/gtest.h>

#include "ui/tools/harvest_tool.h"
#include "ui/tools/region_tool.h"

namespace guidelight {
namespace {

TEST(RectangleTool, TakesWholePixelsInAnyDirectionOfTheDrag) {
  const auto region = region_between({10.7f, 20.2f}, {3.1f, 5.9f}, 100, 100);
  ASSERT_TRUE(region);
  EXPECT_EQ(region->x0, 3);
  EXPECT_EQ(region->y0, 5);
  EXPECT_EQ(region->x1, 11);
  EXPECT_EQ(region->y1, 21);
}

TEST(RectangleTool, StaysWithinThePicture) {
  const auto region = region_between({-50, -50}, {30, 1000}, 100, 80);
  ASSERT_TRUE(region);
  EXPECT_EQ(region->x0, 0);
  EXPECT_EQ(region->y0, 0);
  EXPECT_EQ(region->x1, 30);
  EXPECT_EQ(region->y1, 80);
  EXPECT_FALSE(region_between({-50, -50}, {-10, -10}, 100, 80)) << "outside";
}

class RectangleToolTest : public ::testing::Test {
 protected:
  RectangleToolTest() {
    RenderSettings settings;
    settings.width = 100;
    settings.height = 100;
    document_.set_settings(settings);
    transform_.set_room({0, 0}, {100, 100}, {100, 100});
  }

  void drag(Tool& tool, Vec2 from, Vec2 to) {
    tool.press(document_, at(from));
    tool.drag(document_, at(0.5f * (from + to)));
    EXPECT_FALSE(tool.finished());
    tool.release(document_, at(to));
    EXPECT_TRUE(tool.finished());
  }
  ToolView at(Vec2 mouse) const { return {projection_, &transform_, {}, false, mouse}; }

  Document document_{[] {}};
  ViewTransform transform_;
  ViewProjection projection_{Camera({}, {}), {0, 0}, 1, 0.1f, 10};
};

TEST_F(RectangleToolTest, ADragSetsTheRegionAndAClickClearsIt) {
  RegionTool tool;
  drag(tool, {10, 10}, {40, 50});
  ASSERT_TRUE(document_.settings().region);
  EXPECT_EQ(document_.settings().region->x1, 40);
  RegionTool another;
  drag(another, {10, 10}, {10, 10});
  EXPECT_FALSE(document_.settings().region);
}

TEST_F(RectangleToolTest, TheHarvestedRectangleComesBeforeTheInspectedPixel) {
  document_.view().inspected_pixel = {7, 8};
  EXPECT_EQ(document_.view().harvested(), (PixelRegion{7, 8, 8, 9}));
  HarvestTool tool;
  drag(tool, {10, 20}, {40, 50});
  EXPECT_EQ(document_.view().harvested(), (PixelRegion{10, 20, 40, 50}));
  EXPECT_FALSE(document_.settings().region) << "what is rendered stays";
  HarvestTool another;
  drag(another, {10, 10}, {10, 10});
  EXPECT_EQ(document_.view().harvested(), (PixelRegion{7, 8, 8, 9}));
}

TEST_F(RectangleToolTest, EscapePutsItAside) {
  HarvestTool tool;
  tool.press(document_, at({10, 10}));
  EXPECT_TRUE(tool.take(document_, ToolCommand::Cancel));
  EXPECT_TRUE(tool.finished());
  EXPECT_FALSE(document_.view().harvested_region);
}

}  // namespace
}  // namespace guidelight

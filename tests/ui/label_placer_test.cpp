#include "ui/label_placer.h"

#include <gtest/gtest.h>

namespace guidelight {
namespace {

constexpr Vec2 kSize{40, 10};

TEST(LabelPlacer, StandsToTheRightWhereThereIsRoom) {
  const Vec2 corner = LabelPlacer({200, 100}).place({100, 50}, kSize, 5);
  EXPECT_EQ(corner, Vec2(105, 45));
}

TEST(LabelPlacer, LabelsOfOnePointDoNotCoverEachOther) {
  LabelPlacer labels({200, 100});
  std::vector<Vec2> corners;
  for (int i = 0; i < 8; ++i) corners.push_back(labels.place({100, 50}, kSize, 8));
  for (size_t i = 0; i < corners.size(); ++i) {
    for (size_t j = 0; j < i; ++j) {
      const Vec2 apart = glm::abs(corners[i] - corners[j]);
      EXPECT_TRUE(apart.x >= kSize.x || apart.y >= kSize.y) << i << " and " << j;
    }
  }
}

TEST(LabelPlacer, StayWithinTheRoom) {
  LabelPlacer labels({60, 30});
  for (int i = 0; i < 20; ++i) {
    const Vec2 corner = labels.place({58, 1}, kSize, 5);
    EXPECT_GE(corner.x, 0);
    EXPECT_GE(corner.y, 0);
    EXPECT_LE(corner.x, 60 - kSize.x);
    EXPECT_LE(corner.y, 30 - kSize.y);
  }
}

}  // namespace
}  // namespace guidelight

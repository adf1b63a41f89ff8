#include "renderer/math/angle.h"

#include <gtest/gtest.h>

namespace guidelight {
namespace {

TEST(Angle, FastAtan2IsAtan2) {
  for (int i = -100000; i <= 100000; ++i) {
    const float angle = kPi * static_cast<float>(i) / 100000;
    for (const float radius : {1e-3f, 1.0f, 300.0f}) {
      const float x = radius * std::cos(angle);
      const float y = radius * std::sin(angle);
      ASSERT_NEAR(fast_atan2(y, x), std::atan2(y, x), 6e-7f) << angle;
    }
  }
  EXPECT_EQ(fast_atan2(0, 0), 0);
  EXPECT_FLOAT_EQ(fast_atan2(0, -1), kPi);
  EXPECT_FLOAT_EQ(fast_atan2(-2, 0), -0.5f * kPi);
}

}  // namespace
}  // namespace guidelight

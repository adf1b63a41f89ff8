#include "ui/picture_texture.h"

#include <gtest/gtest.h>

namespace guidelight {
namespace {

/// Red is the column and green the row.
DisplayImage coordinates(int width, int height) {
  DisplayImage image{width, height, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      image.rgba.insert(image.rgba.end(),
                        {static_cast<uint8_t>(x), static_cast<uint8_t>(y), 0, 255});
    }
  }
  return image;
}

TEST(PictureTexture, WhatIsTooLargeIsReducedToTheMiddlesOfSquares) {
  const DisplayImage image = coordinates(100, 7);
  const DisplayImage small = reduced(image, 34);
  ASSERT_EQ(small.width, 34);
  ASSERT_EQ(small.height, 3);
  ASSERT_EQ(small.rgba.size(), 4u * 34 * 3);
  EXPECT_EQ(small.rgba[0], 1);  // the first square's middle
  EXPECT_EQ(small.rgba[1], 1);
  EXPECT_EQ(small.rgba[4 * (34 * 2 + 33)], 99) << "the last square is cut off by the edge";
  EXPECT_EQ(small.rgba[4 * (34 * 2 + 33) + 1], 6);
}

TEST(PictureTexture, WhatFitsStaysAsItIs) {
  const DisplayImage image = coordinates(20, 10);
  EXPECT_EQ(reduced(image, 20).rgba, image.rgba);
}

}  // namespace
}  // namespace guidelight

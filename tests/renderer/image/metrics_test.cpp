#include "renderer/image/metrics.h"

#include <gtest/gtest.h>

#include "renderer/error.h"

namespace guidelight {
namespace {

Image grey(int width, int height, float value) {
  Image image(width, height, 1);
  std::ranges::fill(image.data(), value);
  return image;
}

TEST(Metrics, HandComputedCase) {
  Image reference = grey(2, 1, 1);
  Image image = grey(2, 1, 1);
  reference.pixel(1, 0)[0] = 2;
  image.pixel(0, 0)[0] = 1.5f;
  image.pixel(1, 0)[0] = 1;
  const ImageMetrics m = compare_images(image, reference);
  // (0.5/1)² and (1/2)²; 0.25/1.01 and 1/4.01; 0.5 and 1; means 1.25 and 1.5.
  EXPECT_NEAR(m.rms_relative_error.plain, 0.5, 1e-9);
  EXPECT_NEAR(m.relative_mse.plain, 0.5 * (0.25 / 1.01 + 1 / 4.01), 1e-9);
  EXPECT_NEAR(m.mean_absolute_error.plain, 0.75, 1e-9);
  EXPECT_NEAR(m.mean, 1.25, 1e-9);
  EXPECT_NEAR(m.reference_mean, 1.5, 1e-9);
  EXPECT_NEAR(m.relative_bias, -1.0 / 6, 1e-9);
  EXPECT_NEAR(m.largest_block_bias, 1.0 / 6, 1e-6);
  EXPECT_EQ(m.pixels, 2u);
}

TEST(Metrics, ColoursAreAveragedOverChannels) {
  Image reference(1, 1, 3);
  Image image(1, 1, 3);
  image.pixel(0, 0)[0] = 0.3f;
  const ImageMetrics m = compare_images(image, reference);
  EXPECT_NEAR(m.mean_absolute_error.plain, 0.1, 1e-7);
  EXPECT_NEAR(m.relative_mse.plain, 0.09 / 0.01 / 3, 1e-5);
  EXPECT_EQ(m.black_reference, 1u);
  EXPECT_EQ(m.rms_relative_error.plain, 0);
  EXPECT_TRUE(std::isinf(m.relative_bias));
}

TEST(Metrics, RobustVersionsDropTheWorstThousandth) {
  const Image reference = grey(50, 40, 1);  // 2000 pixels: two may go
  Image image = grey(50, 40, 1.1f);
  image.pixel(7, 7)[0] = 1001;
  image.pixel(8, 7)[0] = 2001;
  const ImageMetrics m = compare_images(image, reference);
  EXPECT_NEAR(m.mean_absolute_error.plain, 0.1 * 0.999 + 1.5, 1e-4);
  EXPECT_NEAR(m.mean_absolute_error.robust, 0.1, 1e-6);
  EXPECT_NEAR(m.rms_relative_error.robust, 0.1, 1e-6);
  EXPECT_NEAR(m.relative_mse.robust, 0.01 / 1.01, 1e-6);
  EXPECT_GT(m.rms_relative_error.plain, 40);
}

TEST(Metrics, WhatIsNotFiniteIsCounted) {
  const Image reference = grey(4, 4, 1);
  Image image = grey(4, 4, 2);
  image.pixel(0, 0)[0] = kInfinity;
  image.pixel(1, 0)[0] = std::numeric_limits<float>::quiet_NaN();
  const ImageMetrics m = compare_images(image, reference);
  EXPECT_EQ(m.not_finite, 2u);
  EXPECT_EQ(m.pixels, 14u);
  EXPECT_NEAR(m.mean, 2, 1e-9);
  const Image map = relative_error_map(image, reference);
  EXPECT_TRUE(std::isnan(map.pixel(1, 0)[0]));
  EXPECT_NEAR(map.pixel(2, 0)[0], 1 / 1.01, 1e-6);
}

TEST(Metrics, BiasIsMeasuredByBlocks) {
  const Image reference = grey(33, 16, 1);  // the third block is one column wide
  Image image = grey(33, 16, 1);
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 16; ++x) image.pixel(x, y)[0] = (x + y) % 2 ? 1.5f : 0.5f;
    image.pixel(20, y)[0] = 2.6f;  // one column of sixteen
    image.pixel(32, y)[0] = 0.5f;
  }
  const Image blocks = block_bias(image, reference);
  ASSERT_EQ(blocks.width(), 3);
  ASSERT_EQ(blocks.height(), 1);
  EXPECT_NEAR(blocks.pixel(0, 0)[0], 0, 1e-6);
  EXPECT_NEAR(blocks.pixel(1, 0)[0], 0.1, 1e-6);
  EXPECT_NEAR(blocks.pixel(2, 0)[0], -0.5, 1e-6);
  const ImageMetrics m = compare_images(image, reference);
  EXPECT_NEAR(m.largest_block_bias, 0.5, 1e-6);
  EXPECT_NEAR(m.rms_block_bias, std::sqrt((0.01 + 0.25) / 3), 1e-6);
}

TEST(Metrics, DifferentSizesAreAnError) {
  EXPECT_THROW(compare_images(grey(2, 2, 1), grey(2, 3, 1)), Error);
  EXPECT_THROW(compare_images(Image(), Image()), Error);
  EXPECT_THROW(block_bias(grey(3, 2, 1), grey(2, 2, 1)), Error);
}

TEST(Metrics, EfficiencyDoesNotDependOnTheSampleCount) {
  EXPECT_DOUBLE_EQ(efficiency(0.1, 4), efficiency(0.05, 8));
  EXPECT_DOUBLE_EQ(efficiency(0.5, 4), 0.5);
}

}  // namespace
}  // namespace guidelight

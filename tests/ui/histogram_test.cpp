#include "ui/histogram.h"

#include <gtest/gtest.h>

namespace guidelight {
namespace {

int bin_of_ev(float ev) {
  return static_cast<int>((ev - Histogram::kMinEv) / (Histogram::kMaxEv - Histogram::kMinEv) *
                          Histogram::kBins);
}

TEST(Histogram, CountsEachChannelInItsBin) {
  Image image(2, 1, 3);
  image.pixel(0, 0)[0] = 1.01f;                              // just above 2^0
  image.pixel(0, 0)[1] = 4.01f;                              // just above 2^2
  for (int c = 0; c < 3; ++c) image.pixel(1, 0)[c] = 1.01f;  // blue is 0 in the first pixel
  const Histogram histogram = make_histogram(image);
  EXPECT_EQ(histogram.counts[0][bin_of_ev(0)], 2u);
  EXPECT_EQ(histogram.counts[1][bin_of_ev(0)], 1u);
  EXPECT_EQ(histogram.counts[1][bin_of_ev(2)], 1u);
  EXPECT_EQ(histogram.counts[2][bin_of_ev(0)], 1u);
  EXPECT_EQ(histogram.tallest, 2u);
  EXPECT_EQ(histogram.zero, 0u);
}

TEST(Histogram, CountsBlackAndBrokenPixelsApart) {
  Image image(4, 1, 1);
  image.pixel(0, 0)[0] = 0;
  image.pixel(1, 0)[0] = std::nanf("");
  image.pixel(2, 0)[0] = kInfinity;
  image.pixel(3, 0)[0] = 1e30f;  // beyond the axis: counts in the last bin
  const Histogram histogram = make_histogram(image);
  EXPECT_EQ(histogram.zero, 1u);
  EXPECT_EQ(histogram.not_finite, 2u);
  EXPECT_EQ(histogram.counts[0].back(), 1u);
}

TEST(ValueRange, LeavesOutTheFewExtremes) {
  Image image(1000, 1, 1);
  for (int x = 0; x < 1000; ++x) image.pixel(x, 0)[0] = 1 + static_cast<float>(x);
  image.pixel(3, 0)[0] = 1e9f;
  image.pixel(4, 0)[0] = kInfinity;
  const auto [low, high] = value_range(image);
  EXPECT_NEAR(low, 11, 3);
  EXPECT_NEAR(high, 996, 4);
}

TEST(ValueRange, IsUsableForAnyImage) {
  for (const float value : {0.0f, 5.0f, std::nanf("")}) {
    Image image(3, 3, 1);
    for (float& pixel : image.data()) pixel = value;
    const auto [low, high] = value_range(image);
    EXPECT_GT(low, 0);
    EXPECT_GT(high, low);
  }
}

}  // namespace
}  // namespace guidelight

#include "ui/format.h"

#include <gtest/gtest.h>

#include <limits>

namespace guidelight {
namespace {

TEST(Format, CountsKeepThreeDigits) {
  EXPECT_EQ(format_count(0), "0");
  EXPECT_EQ(format_count(999), "999");
  EXPECT_EQ(format_count(1000), "1.00 k");
  EXPECT_EQ(format_count(12345), "12.3 k");
  EXPECT_EQ(format_count(999'499), "999 k");
  EXPECT_EQ(format_count(999'600), "1.00 M");
  EXPECT_EQ(format_count(3'456'789), "3.46 M");
  EXPECT_EQ(format_count(2e9), "2.00 G");
}

TEST(Format, DurationsChangeUnitWithoutAGap) {
  EXPECT_EQ(format_duration(0), "0.0 s");
  EXPECT_EQ(format_duration(4.25), "4.2 s");
  EXPECT_EQ(format_duration(59.94), "59.9 s");
  EXPECT_EQ(format_duration(59.96), "1:00");
  EXPECT_EQ(format_duration(83), "1:23");
  EXPECT_EQ(format_duration(3723), "1:02:03");
}

TEST(Format, ValuesThatAreNoNumbersAreNamed) {
  EXPECT_EQ(format_value(0.12345f), "0.1235");
  EXPECT_EQ(format_value(1.5e-7f), "1.5e-07");
  EXPECT_EQ(format_value(std::numeric_limits<float>::quiet_NaN()), "NaN");
  EXPECT_EQ(format_value(std::numeric_limits<float>::infinity()), "∞");
  EXPECT_EQ(format_value(-std::numeric_limits<float>::infinity()), "-∞");
}

TEST(Format, ThreeValuesHaveThreeDigitsOfTheLargest) {
  EXPECT_EQ(format_triple({16.61f, 0.02f, 11.4f}), "16.6  0.0  11.4");
  EXPECT_EQ(format_triple({0.0939f, 0.126f, 1.125f}), "0.09  0.13  1.12");
  EXPECT_EQ(format_triple({-1, 0, -1e-9f}), "-1.00  0.00  0.00");
  EXPECT_EQ(format_triple({4321, 1, 0}), "4321  1  0");
  EXPECT_EQ(format_triple(Vec3(0)), "0.00  0.00  0.00");
}

TEST(Format, VerySmallOrLargeTriplesShareAPowerOfTen) {
  EXPECT_EQ(format_triple({1.23e-5f, 4e-7f, 5.6e-5f}), "1.23  0.04  5.60 ×10⁻⁵");
  EXPECT_EQ(format_triple({1e12f, 0, -2.5e12f}), "1.00  0.00  -2.50 ×10¹²");
  EXPECT_EQ(format_triple({1, std::numeric_limits<float>::quiet_NaN(), 2}), "1  NaN  2");
}

TEST(Format, PercentAndBytes) {
  EXPECT_EQ(format_percent(82'770), "8.3e+06 %");
  EXPECT_EQ(format_percent(0.0234), "2.3 %");
  EXPECT_EQ(format_percent(0.0012), "0.12 %");
  EXPECT_EQ(format_percent(0.5), "50 %");
  EXPECT_EQ(format_bytes(100), "100 bytes");
  EXPECT_EQ(format_bytes(1536), "1.5 KiB");
  EXPECT_EQ(format_bytes(3ull << 30), "3.0 GiB");
}

}  // namespace
}  // namespace guidelight

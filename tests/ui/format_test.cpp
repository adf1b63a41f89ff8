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

TEST(Format, PercentAndBytes) {
  EXPECT_EQ(format_percent(0.0234), "2.3 %");
  EXPECT_EQ(format_percent(0.0012), "0.12 %");
  EXPECT_EQ(format_percent(0.5), "50 %");
  EXPECT_EQ(format_bytes(100), "100 bytes");
  EXPECT_EQ(format_bytes(1536), "1.5 KiB");
  EXPECT_EQ(format_bytes(3ull << 30), "3.0 GiB");
}

}  // namespace
}  // namespace guidelight

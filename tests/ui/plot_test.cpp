#include "ui/plot.h"

#include <gtest/gtest.h>

namespace guidelight {
namespace {

TEST(Plot, TheValuesUnderTheMouseAreThoseOfTheNearestPoints) {
  const std::vector<PlotCurve> curves = {{"a", 0, {{1, 0.5f}, {10, 0.25f}, {100, 0.125f}}},
                                         {"b", 0, {{1, 7}, {100, 9}}},
                                         {"none", 0, {}}};
  const PlotAxes axes{"s", "m", true, true};
  EXPECT_EQ(plot_values(curves, axes, 0.45f), "a: 0.25 m at 10 s\nb: 7 m at 1 s");
  EXPECT_EQ(plot_values(curves, axes, 2), "a: 0.125 m at 100 s\nb: 9 m at 100 s");
  const PlotAxes linear{"s", "m", false, false};
  EXPECT_EQ(plot_values(curves, linear, 0.45f), "a: 0.25 m at 10 s\nb: 7 m at 1 s");
  EXPECT_EQ(plot_values(curves, linear, 0.7f), "a: 0.125 m at 100 s\nb: 9 m at 100 s");
}

TEST(Plot, WhatIsNotShownHasNoValue) {
  const std::vector<PlotCurve> curve = {{"", 0, {{1, 0}, {2, 4}}}};
  EXPECT_EQ(plot_values(curve, {"", "", true, true}, 0), "4 at 2") << "no logarithm of 0";
  EXPECT_EQ(plot_values({}, {}, 0), "");
}

}  // namespace
}  // namespace guidelight

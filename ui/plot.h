#pragma once

#include <imgui.h>

#include <span>
#include <string>
#include <vector>

#include "renderer/math/vector.h"

namespace guidelight {

/// A line of a plot.
struct PlotCurve {
  std::string name;  // empty: not in the legend
  ImU32 color;
  std::vector<Vec2> points;  // by x
};

/// A small plot that fills the width: curves, the ends of both axes, a legend, and the values under
/// the mouse. Logarithmic axes leave out what is not positive.
struct PlotAxes {
  std::string x_unit;
  std::string y_unit;
  bool logarithmic_x = false;
  bool logarithmic_y = false;
};
/// Of each curve on a line of its own, the point nearest to a place along the x axis, 0 … 1 from
/// its lower end. Empty if nothing is plotted.
std::string plot_values(std::span<const PlotCurve> curves, const PlotAxes& axes, float x_share);

void draw_plot(const char* id, std::span<const PlotCurve> curves, const PlotAxes& axes);

}  // namespace guidelight

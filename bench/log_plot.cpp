#include "bench/log_plot.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "renderer/io/atomic_file.h"

namespace guidelight {

namespace {

constexpr double kWidth = 720;
constexpr double kHeight = 440;
constexpr double kLeft = 70;
constexpr double kRight = 150;
constexpr double kTop = 40;
constexpr double kBottom = 55;
constexpr std::array kColors = {"#4269d0", "#efb118", "#ff725c", "#6cc5b0", "#9c6b4e", "#97bbf5"};

/// Maps a logarithmic range to a range of the drawing.
struct Axis {
  double lowest;  // powers of ten
  double highest;
  double from;
  double to;
  double at(double value) const {
    return from + (std::log10(value) - lowest) / (highest - lowest) * (to - from);
  }
};

Axis axis_over(const std::vector<LogSeries>& series, std::vector<double> LogSeries::*values,
               double from, double to) {
  double lowest = 1e30, highest = -1e30;
  for (const LogSeries& line : series) {
    for (const double value : line.*values) {
      lowest = std::min(lowest, std::log10(value));
      highest = std::max(highest, std::log10(value));
    }
  }
  const double margin = 0.05 * (highest - lowest);
  return {lowest - margin, highest + margin, from, to};
}

/// 1, 2 and 5 times the powers of ten within an axis.
std::vector<double> ticks(const Axis& axis) {
  std::vector<double> list;
  for (double power = std::floor(axis.lowest); power <= axis.highest; ++power) {
    for (const double digit : {1, 2, 5}) {
      const double position = power + std::log10(digit);
      if (position >= axis.lowest && position <= axis.highest) {
        list.push_back(digit * std::pow(10, power));
      }
    }
  }
  return list;
}

}  // namespace

double fitted_exponent(const LogSeries& series) {
  const auto n = static_cast<double>(series.x.size());
  double sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (size_t i = 0; i < series.x.size(); ++i) {
    const double x = std::log(series.x[i]);
    const double y = std::log(series.y[i]);
    sx += x, sy += y, sxx += x * x, sxy += x * y;
  }
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

void write_log_plot(const std::string& path, const std::string& title, const std::string& x_label,
                    const std::string& y_label, const std::vector<LogSeries>& series) {
  const Axis x = axis_over(series, &LogSeries::x, kLeft, kWidth - kRight);
  const Axis y = axis_over(series, &LogSeries::y, kHeight - kBottom, kTop);
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" "
      "font-family=\"sans-serif\" font-size=\"13\">\n<rect width=\"{0}\" height=\"{1}\" "
      "fill=\"white\"/>\n<text x=\"{2}\" y=\"24\" font-size=\"15\">{3}</text>\n",
      kWidth, kHeight, kLeft, title);
  for (const double tick : ticks(x)) {
    svg += fmt::format(
        "<line x1=\"{0}\" x2=\"{0}\" y1=\"{1}\" y2=\"{2}\" stroke=\"#ddd\"/>"
        "<text x=\"{0}\" y=\"{3}\" text-anchor=\"middle\">{4:g}</text>\n",
        x.at(tick), y.to, y.from, y.from + 18, tick);
  }
  for (const double tick : ticks(y)) {
    svg += fmt::format(
        "<line x1=\"{1}\" x2=\"{2}\" y1=\"{0}\" y2=\"{0}\" stroke=\"#ddd\"/>"
        "<text x=\"{3}\" y=\"{4}\" text-anchor=\"end\">{5:g}</text>\n",
        y.at(tick), x.from, x.to, x.from - 6, y.at(tick) + 4, tick);
  }
  svg += fmt::format(
      "<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n"
      "<text transform=\"translate(18 {}) rotate(-90)\" text-anchor=\"middle\">{}</text>\n",
      (x.from + x.to) / 2, kHeight - 12, x_label, (y.from + y.to) / 2, y_label);
  for (size_t i = 0; i < series.size(); ++i) {
    const LogSeries& line = series[i];
    std::string points;
    for (size_t k = 0; k < line.x.size(); ++k) {
      points += fmt::format("{:.1f},{:.1f} ", x.at(line.x[k]), y.at(line.y[k]));
    }
    svg += fmt::format(
        "<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\"/>\n"
        "<text x=\"{}\" y=\"{}\" fill=\"{}\">{}</text>\n",
        points, kColors[i % kColors.size()], x.to + 10, kTop + 18 * static_cast<double>(i + 1),
        kColors[i % kColors.size()], line.name);
  }
  write_file_atomically(path, svg + "</svg>\n");
}

}  // namespace guidelight

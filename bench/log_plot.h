#pragma once

#include <string>
#include <vector>

namespace guidelight {

/// A line of a plot with logarithmic axes.
struct LogSeries {
  std::string name;
  std::vector<double> x;
  std::vector<double> y;
};

/// Slope of log y over log x, by least squares.
double fitted_exponent(const LogSeries& series);

/// Writes a plot as SVG.
void write_log_plot(const std::string& path, const std::string& title, const std::string& x_label,
                    const std::string& y_label, const std::vector<LogSeries>& series);

}  // namespace guidelight

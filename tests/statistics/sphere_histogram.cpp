#include "tests/statistics/sphere_histogram.h"

#include <algorithm>

namespace guidelight::statistics {

size_t SphereGrid::cell(Vec3 w) const {
  double phi = std::atan2(double(w.y), double(w.x));
  if (phi < 0) phi += 2 * std::numbers::pi;
  const int row = std::clamp(static_cast<int>((w.z + 1.0) / 2 * cosines_), 0, cosines_ - 1);
  const int column =
      std::clamp(static_cast<int>(phi / (2 * std::numbers::pi) * azimuths_), 0, azimuths_ - 1);
  return static_cast<size_t>(row) * azimuths_ + column;
}

SphereGrid::Rectangle SphereGrid::rectangle(size_t cell) const {
  const double row = static_cast<double>(cell / azimuths_);
  const double column = static_cast<double>(cell % azimuths_);
  const double width = 2 * std::numbers::pi / azimuths_;
  return {-1 + 2 * row / cosines_, -1 + 2 * (row + 1) / cosines_, column * width,
          (column + 1) * width};
}

}  // namespace guidelight::statistics

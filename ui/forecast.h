#pragma once

#include <algorithm>

namespace guidelight {

/// How much longer it takes until the error has fallen to `target` [s], if it goes on falling with
/// the root of the time; 0 once it has.
inline double seconds_until_error(double seconds, double error, double target) {
  const double ratio = error / target;
  return seconds * std::max(0.0, ratio * ratio - 1);
}

}  // namespace guidelight

#pragma once

#include <iterator>

#include "renderer/math/vector.h"

namespace guidelight {

/// Tells the guides of a list apart: colours of equal brightness, also for people who confuse red
/// and green (Okabe and Ito 2008).
inline Color guide_color(size_t index) {
  static const Color kColors[] = {{0.90f, 0.62f, 0.00f}, {0.34f, 0.71f, 0.91f},
                                  {0.00f, 0.75f, 0.55f}, {0.94f, 0.89f, 0.26f},
                                  {0.80f, 0.47f, 0.65f}, {0.84f, 0.37f, 0.00f}};
  return kColors[index % std::size(kColors)];
}

}  // namespace guidelight

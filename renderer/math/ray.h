#pragma once

#include "renderer/math/vector.h"

namespace guidelight {

/// Half-open segment origin + t·direction for t in (0, t_max). The direction need not have unit
/// length (shadow rays span exactly t in (0,1)); path segments use unit directions.
struct Ray {
  Vec3 origin{0};
  Vec3 direction{0, 0, 1};
  float t_max = kInfinity;
};

}  // namespace guidelight

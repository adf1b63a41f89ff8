#pragma once

#include "renderer/scene/scene.h"

namespace guidelight {

/// A surface point at rest: what is needed to look it up again, a quarter of the size of a
/// SurfacePoint.
struct StoredPoint {
  Hit hit;
  Vec3 position{0};
  Vec3 wo{0};  // unit, towards the vertex before

  SurfacePoint restore(const Scene& scene) const {
    return scene.surface_point({position + hit.t * wo, -wo, kInfinity}, hit);
  }
};

}  // namespace guidelight

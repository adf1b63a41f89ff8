#pragma once

#include "renderer/integrators/parameters.h"
#include "renderer/transport/ray_footprint.h"

namespace guidelight {

/// Settings of how far photons are searched for at first, shared by the methods whose radius is not
/// that of the k nearest.
struct RadiusSettings {
  int radius_from = 0;        // 0: the scene's size, 1: the pixel's footprint
  float scene_radius = 0.3f;  // [% of the scene's bounding sphere's]
  float pixel_radius = 2;     // [pixels]

  std::vector<Parameter> radius_parameters();
  bool radius_is_zero() const { return (radius_from == 0 ? scene_radius : pixel_radius) == 0; }
};

/// The initial search radius [scene units]. From the scene's size it is the same everywhere, from
/// the pixel's footprint it grows with the way from the camera, and with what curved mirrors and
/// glass do to the beam.
class SearchRadius {
 public:
  SearchRadius(const Scene& scene, const RadiusSettings& settings);

  /// `footprint`: of the camera path up to its first vertex that is not specular; null where
  /// needs_footprint() is false.
  float at(const RayFootprint* footprint) const {
    return footprint ? per_spread_ * footprint->spread() : constant_;
  }
  bool needs_footprint() const { return per_spread_ > 0; }
  /// At a point that the camera sees at a distance without any bounce.
  float seen_directly(const Camera& camera, float distance) const {
    return constant_ + per_spread_ * RayFootprint::seen_directly(camera, distance);
  }
  /// At the middle of the scene.
  float typical() const { return typical_; }

 private:
  float constant_ = 0;
  float per_spread_ = 0;
  float typical_;
};

}  // namespace guidelight

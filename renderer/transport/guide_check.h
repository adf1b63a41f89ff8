#pragma once

#include <optional>
#include <string>
#include <vector>

#include "renderer/scene/scene.h"
#include "renderer/transport/guide_path.h"

namespace guidelight {

/// Why a guide does not fit a scene.
struct GuideFault {
  int vertex;           // that is at fault, or that the faulty segment leads to
  std::string message;  // one sentence: what is wrong and what to do
};

/// Faults of a guide, the first along the path first; empty if it can be used. Not on a light, not
/// ending where light is scattered, a blocked segment, a specular event that the surface does not
/// have or that leads elsewhere, a number that is not finite or out of range.
std::vector<GuideFault> check_guide(const Scene& scene, const GuidePath& guide);

/// A guide whose vertices have been found in a scene. Vertex 0 of a light without surface has a
/// position alone.
struct PlacedGuide {
  const Light* light = nullptr;
  std::vector<SurfacePoint> points;
};

/// Looks up the vertices of a guide; adds to `faults` what check_guide() reports, and is of use
/// only where that is nothing.
PlacedGuide place_guide(const Scene& scene, const GuidePath& guide,
                        std::vector<GuideFault>& faults);

/// Vertices of a guide lie this close to where they are found [scene units].
float guide_tolerance(const Scene& scene);

/// The light that a path leaves from a position in a unit direction, and its point there.
struct LightOrigin {
  const Light* light;
  SurfacePoint point;  // see PlacedGuide
};
/// Empty if no light within guide_tolerance() of the position shines that way.
std::optional<LightOrigin> find_light(const Scene& scene, Vec3 position, Vec3 direction);

/// What leaves a light in a unit direction: radiance of areas and the sky, intensity of points,
/// irradiance of parallel light. `point` as in PlacedGuide.
Color emitted_light(const Light& light, const SurfacePoint& point, Vec3 direction);

}  // namespace guidelight

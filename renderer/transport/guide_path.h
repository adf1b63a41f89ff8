#pragma once

#include <string>
#include <vector>

#include "renderer/scene/bsdf/bsdf.h"

namespace guidelight {

/// How a path goes on from a vertex.
enum class PathEvent : uint8_t {
  Scatter,  // emission, or scattering by a finite lobe: the direction is free
  Reflect,  // by a mirror
  Refract,  // by a perfectly smooth interface, or straight on
};

/// The event of a sampled lobe.
inline PathEvent path_event(Lobe lobe) {
  return lobe == kLobeDeltaReflection     ? PathEvent::Reflect
         : lobe == kLobeDeltaTransmission ? PathEvent::Refract
                                          : PathEvent::Scatter;
}

/// The lobe that an event needs; none where the direction is free.
inline Lobe lobe_of(PathEvent event) {
  return event == PathEvent::Reflect   ? kLobeDeltaReflection
         : event == PathEvent::Refract ? kLobeDeltaTransmission
                                       : kLobeNone;
}

/// Directions of a fresh guide lie within this angle of it [rad]: 5°.
inline constexpr float kDefaultGuideCone = 5 * kPi / 180;

struct GuideVertex {
  Vec3 position{0};
  PathEvent event = PathEvent::Scatter;  // not used at the last vertex
  /// Half-angle β of the cone of directions that leave here, in (0, π/2] [rad]; of a Scatter event
  /// only, and not used at the last vertex.
  float cone = kDefaultGuideCone;
};

/// A path that somebody has drawn from a light towards where its light is wanted (Fan et al. 2005,
/// section 5): light paths like it are proposed more often, which changes no result, only the
/// noise. Plain data; check_guide() says whether it fits a scene.
struct GuidePath {
  std::string name;
  Color color{1.0f, 0.55f, 0.1f};  // in the viewer
  bool enabled = true;
  float weight = 1;  // share among the guides, ≥ 0; need not sum to 1
  /// Paths start within this distance of vertex 0, measured across the light's normal there [scene
  /// units]. For a light at infinity they pass vertex 1 within this distance. Not used where
  /// the light is a point.
  float disc_radius = 0.05f;
  /// The first on a light, the last on a surface that scatters by a finite lobe; the vertices of
  /// specular events are listed, too. At least two. Where the light is at infinity, the first is
  /// any point on the way from it to the second.
  std::vector<GuideVertex> vertices;
};

}  // namespace guidelight

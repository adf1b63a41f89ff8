#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "renderer/transport/guide_trace.h"

namespace guidelight {

/// A place on a light where a path can begin.
struct LightPlace {
  const Light* light = nullptr;
  SurfacePoint point;     // of lights without surface the position alone
  Vec3 towards_sky{0};    // of lights at infinity, unit; zero for all others
  float disc_radius = 1;  // that suits the light [scene units]
};

/// The light that a ray meets, clear surfaces before it ignored; else a point light for which
/// `is_near` holds; else, if the ray leaves the scene, the light at infinity there.
std::optional<LightPlace> pick_light(const Scene& scene, const Ray& ray,
                                     const std::function<bool(Vec3)>& is_near);

/// How a path goes on: over specular surfaces to the next that scatters.
struct Continuation {
  std::vector<GuideVertex> vertices;  // the last one scatters; empty if the path leads nowhere
  SurfacePoint end;                   // the last vertex
  std::string problem;                // why it is not what was aimed at; empty if it is
};

/// A path that is being placed, from a light from one scattering surface to the next.
class GuideDraft {
 public:
  bool empty() const { return !light_; }
  size_t segments() const { return segments_.size(); }
  void begin(const Scene& scene, const LightPlace& light);
  void clear();

  /// The way on to a point of a surface; specular surfaces are followed from there.
  Continuation aim(const Scene& scene, const SurfacePoint& target, SpecularChoice choice) const;
  void add(Continuation next) { segments_.push_back(std::move(next)); }
  /// Places a whole path that was traced from the draft's light instead of what was placed.
  void take(const Scene& scene, const GuidePath& traced);
  /// Takes back the last segment, or the light if there is none.
  void remove_last();

  /// Positions so far; of a light in the sky nothing before the first segment.
  std::vector<Vec3> points() const;
  std::optional<Vec3> light_position() const;
  /// Of at least one segment.
  GuidePath path() const;

 private:
  Vec3 start_before(Vec3 next) const;

  std::optional<LightPlace> light_;
  float sky_distance_ = 1;  // from the scene to the first vertex [scene units]
  std::vector<Continuation> segments_;
};

}  // namespace guidelight

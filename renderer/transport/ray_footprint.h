#pragma once

#include "renderer/transport/path_vertex.h"

namespace guidelight {

/// How wide the beam around a camera ray has become by specular bounces: the derivatives of the ray
/// by the two directions across it where it left the lens, carried through curved mirrors and glass
/// (Igehy 1999, "Tracing Ray Differentials"). Bumps of a normal map count with their slope, but as
/// flat as the surface without them.
class RayFootprint {
 public:
  /// Of a camera ray in a unit direction; `is_parallel` if the camera's rays are.
  RayFootprint(Vec3 direction, bool is_parallel);

  /// The ray, which has left `origin`, has come to a vertex. Each but the last scatters by a delta
  /// lobe.
  void arrive(const Scene& scene, Vec3 origin, const PathVertex& vertex);

  /// Width of the beam across the ray at the last vertex, for a beam as wide in both directions and
  /// of the same area [scene units per radian at the lens; of parallel rays, per scene unit there].
  /// With flat mirrors this is the length of the path (for parallel rays 1); where curved ones
  /// bundle or scatter it, it is kept within a factor of 8 of that.
  float spread() const { return spread_; }
  /// What spread() is at a point that the camera sees at a distance without any bounce.
  static float seen_directly(const Camera& camera, float distance) {
    return camera.description().model == CameraModel::Orthographic ? 1.0f : distance;
  }

 private:
  /// The surface that the ray has come to.
  struct Surface {
    Hit hit;
    Vec3 position;
    Vec3 normal;     // that it scatters about
    float eta;       // IOR where the ray comes from over that beyond
    Vec3 direction;  // unit, of the ray that arrives
  };
  void scatter(const Scene& scene, Vec3 direction);

  // By each of the two directions.
  Vec3 position_[2];
  Vec3 direction_[2];
  Surface surface_{};  // valid once a vertex has been reached
  bool is_parallel_;
  bool is_on_surface_ = false;
  float length_ = 0;  // of the path
  float spread_ = 0;
};

}  // namespace guidelight

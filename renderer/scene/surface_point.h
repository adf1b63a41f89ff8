#pragma once

#include <cstdint>

#include "renderer/math/frame.h"
#include "renderer/math/ray.h"

namespace guidelight {

class Bsdf;
class Light;
struct Medium;

/// Index that names nothing.
inline constexpr uint32_t kInvalidIndex = 0xffffffffu;

/// Everything that is known about a point on a surface, in world space.
struct SurfacePoint {
  Vec3 position{0};
  Vec3 geometric_normal{0, 0, 1};  // unit; the shape's outside
  Frame frame;                     // shading frame; frame.n is within 90° of the geometric normal
                                   // except where a mesh's normals contradict each other
  Vec2 uv{0};
  Vec3 dpdu{0};  // zero where the shape has no parametrisation
  Vec3 dpdv{0};
  Color vertex_color{1.0f};

  const Bsdf* bsdf = nullptr;
  const Light* light = nullptr;  // the area light that this surface is, or nullptr
  const Medium* interior = nullptr;
  const Medium* exterior = nullptr;
  bool is_medium_boundary = false;

  uint32_t shape = kInvalidIndex;  // index in Scene::shapes()
  uint32_t primitive = 0;
  uint32_t instance = kInvalidIndex;

  /// How far a ray's origin must be moved along the normal so that rounding cannot make it hit this
  /// surface again. It scales with the arithmetic that produced the point, not with the scene, and
  /// is 0 for a point that is on no surface.
  float offset = 0;

  /// A ray origin just off the surface, on the side that `direction` points to.
  Vec3 offset_origin(Vec3 direction) const {
    const float side = glm::dot(geometric_normal, direction) < 0 ? -offset : offset;
    return position + side * geometric_normal;
  }

  /// Path segment that leaves in a unit direction.
  Ray spawn_ray(Vec3 direction) const { return {offset_origin(direction), direction, kInfinity}; }

  /// Shadow ray to another surface point; the segment is t in (0,1) and misses both surfaces.
  Ray spawn_ray_to(const SurfacePoint& other) const {
    const Vec3 origin = offset_origin(other.position - position);
    return {origin, other.offset_origin(origin - other.position) - origin, 1.0f};
  }

  /// Shadow ray to a point that is not on a surface (a point light, a pinhole).
  Ray spawn_ray_to(Vec3 target) const {
    const Vec3 origin = offset_origin(target - position);
    return {origin, target - origin, 1.0f};
  }
};

/// The medium on the side of the surface that `direction` points to; `current` is the one before.
inline const Medium* medium_beyond(const SurfacePoint& point, Vec3 direction,
                                   const Medium* current) {
  if (!point.is_medium_boundary) return current;
  return glm::dot(point.geometric_normal, direction) < 0 ? point.interior : point.exterior;
}

}  // namespace guidelight

#pragma once

#include <memory>

#include "renderer/scene/description.h"
#include "renderer/scene/surface_point.h"

namespace guidelight {

/// What an intersection query says about a hit.
struct Hit {
  float t = kInfinity;                // in units of the ray's direction; infinity is a miss
  uint32_t shape = kInvalidIndex;     // index in Scene::shapes()
  uint32_t primitive = 0;             // triangle of a mesh
  uint32_t instance = kInvalidIndex;  // index in Scene::instances(), if hit through one
  Vec2 barycentric{0};                // of triangle vertices 1 and 2; unused by analytic shapes

  bool valid() const { return shape != kInvalidIndex; }
};

struct Bounds {
  Vec3 lower{kInfinity};
  Vec3 upper{-kInfinity};

  void extend(Vec3 p) { lower = glm::min(lower, p), upper = glm::max(upper, p); }
  void extend(const Bounds& b) {
    lower = glm::min(lower, b.lower), upper = glm::max(upper, b.upper);
  }
  bool empty() const { return !(lower.x <= upper.x); }
  Vec3 center() const { return 0.5f * (lower + upper); }
  float radius() const { return 0.5f * glm::length(upper - lower); }
};

/// Geometry in world space (in the group's space for shapes of a group). Immutable.
class Shape {
 public:
  virtual ~Shape() = default;

  /// Whether points carry texture coordinates, derivatives and vertex colours. A scene switches it
  /// off for shapes whose materials do not look at them, and hits get cheaper.
  bool is_parametrised = true;

  /// Fills position, geometric normal, frame, uv, derivatives, vertex colour and offset of `point`.
  /// For analytic shapes the position on the ray is projected onto the surface.
  virtual void fill(const Ray& ray, const Hit& hit, SurfacePoint& point) const = 0;

  /// Draws a point, of which it sets position, normals, uv, offset and primitive; returns its
  /// density per unit area. Uniform up to the distortion of an analytic shape's own transform.
  virtual float sample_area(Vec2 u, SurfacePoint& point) const = 0;
  /// Density of sample_area at a point of the surface, per unit area.
  virtual float pdf_area(const SurfacePoint& point) const = 0;

  /// Draws a point as seen from `reference`; where the shape knows no better way, by sample_area.
  /// Returns its density per solid angle at the reference, zero if the point must be dropped.
  virtual float sample_seen_from(Vec3 reference, Vec2 u, SurfacePoint& point) const;
  /// Density of sample_seen_from, per solid angle at the reference.
  virtual float pdf_seen_from(Vec3 reference, const SurfacePoint& point) const;

  /// How the unit normal of fill()'s shading frame changes along a surface: its derivative at a
  /// point of the shape by a displacement in the tangent plane. 0 on flat shapes.
  virtual Vec3 normal_derivative(const Hit& hit, Vec3 position, Vec3 displacement) const {
    (void)hit, (void)position, (void)displacement;
    return Vec3(0);
  }

  virtual float area() const = 0;
  virtual Bounds bounds() const = 0;
  virtual size_t triangle_count() const { return 0; }
  virtual size_t bytes() const { return 0; }  // of memory, about; without a Mesh it may share
};

/// Builds the run-time form of a mesh, sphere, disk or cylinder with the extra transform `parent`
/// applied after its own. Throws Error for geometry that cannot be used (NaN, index out of range,
/// singular).
std::unique_ptr<Shape> make_shape(const ShapeDescription& description,
                                  const Mat4& parent = Mat4(1));

}  // namespace guidelight

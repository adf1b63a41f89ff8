#pragma once

#include <array>
#include <memory>

#include "renderer/scene/shape.h"
#include "renderer/scene/shape_transform.h"

namespace guidelight {

/// A packet of rays, coordinate by coordinate.
struct RayLanes {
  static constexpr size_t kCount = 8;
  using Lanes = std::array<float, kCount>;

  std::array<Lanes, 3> origin;
  std::array<Lanes, 3> direction;
  Lanes t_min;
  Lanes t_max;
};

/// A shape given by an equation in its own space and an affine transform, without facets. Called
/// from the accelerator's user-geometry callbacks.
class AnalyticShape : public Shape {
 public:
  AnalyticShape(const ShapeDescription& description, const Mat4& to_world);

  /// Nearest intersection with t in (t_min, ray.t_max); false leaves t as it is.
  virtual bool intersect(const Ray& ray, float t_min, float& t) const = 0;
  /// The same for all rays of a packet at once; t is infinite where there is none.
  virtual RayLanes::Lanes intersect(const RayLanes& rays) const = 0;

  void fill(const Ray& ray, const Hit& hit, SurfacePoint& point) const override;
  float sample_area(Vec2 u, SurfacePoint& point) const override;
  float pdf_area(const SurfacePoint& point) const override;
  Vec3 normal_derivative(const Hit&, Vec3 position, Vec3 displacement) const override;
  float area() const override { return area_; }
  Bounds bounds() const override;

 protected:
  /// Derivatives and texture coordinates at a local point of the surface.
  struct Parametrisation {
    Vec2 uv;
    Vec3 dpdu;
    Vec3 dpdv;
  };

  /// A point of the surface close to p.
  virtual Vec3 project_local(Vec3 p) const = 0;
  /// Unit normal at a point of the surface.
  virtual Vec3 normal_local(Vec3 p) const = 0;
  /// The derivative of normal_local() by a displacement within the surface.
  virtual Vec3 normal_derivative_local(Vec3 displacement) const = 0;
  virtual Parametrisation parametrise(Vec3 p) const = 0;
  /// Uniform in local area.
  virtual Vec3 sample_local(Vec2 u) const = 0;
  /// World bounds relative to the origin of the local space.
  virtual Bounds bounds_around_origin() const = 0;

  Vec3 to_local(Vec3 world) const { return linear_.inverse * (world - origin_); }
  void fill_local(Vec3 local, SurfacePoint& point) const;
  /// World area per local area where the local unit normal is n.
  float area_factor(Vec3 n) const {
    return std::abs(linear_.determinant) * glm::length(linear_.normal(n));
  }
  void set_area(float local_area, float world_area) {
    local_area_ = local_area;
    area_ = world_area;
  }

  LinearTransform linear_;
  Vec3 origin_;  // of the local space, in world space
  float normal_sign_;

 private:
  float local_area_ = 0;
  float area_ = 0;
};

/// Builds a sphere, disk or cylinder. Throws Error if the transform is singular or not finite, if
/// it goes beyond kLargestCoordinate, or if the geometry is none of these.
std::unique_ptr<AnalyticShape> make_analytic_shape(const ShapeDescription& description,
                                                   const Mat4& to_world);

}  // namespace guidelight

#include "renderer/scene/analytic_shape.h"

#include <algorithm>

#include "renderer/error.h"
#include "renderer/math/angle.h"
#include "renderer/sampling/warp.h"
#include "renderer/scene/reach.h"

namespace guidelight {

namespace {

/// Intersects rays with the shape whose equation is `Equation`, a function
///   static float intersect_local(Vec3 origin, Vec3 direction, float t_min, float t_max)
/// that is infinite without intersection and does without branches, so that the lanes of a packet
/// are computed together.
template <class Equation>
class ShapeOf : public AnalyticShape {
 public:
  using AnalyticShape::AnalyticShape;

  bool intersect(const Ray& ray, float t_min, float& t) const override {
    const float found = Equation::intersect_local(
        to_local(ray.origin), linear_.inverse * ray.direction, t_min, ray.t_max);
    if (found == kInfinity) return false;
    t = found;
    return true;
  }

  /// Flattened: the compiler joins the lanes only if it sees the whole of a loop.
  [[gnu::flatten]] RayLanes::Lanes intersect(const RayLanes& rays) const override {
    const auto at = [](const std::array<RayLanes::Lanes, 3>& lanes, size_t i) {
      return Vec3(lanes[0][i], lanes[1][i], lanes[2][i]);
    };
    const Mat3 inverse = linear_.inverse;
    const Vec3 origin = origin_;
    RayLanes::Lanes t;
    for (size_t i = 0; i < RayLanes::kCount; ++i) {
      t[i] =
          Equation::intersect_local(inverse * (at(rays.origin, i) - origin),
                                    inverse * at(rays.direction, i), rays.t_min[i], rays.t_max[i]);
    }
    return t;
  }
};

struct Roots {
  float near;  // not a number if there are none
  float far;
};

/// Where |origin + t·direction| = 1, in D dimensions. The discriminant is taken from the vector to
/// the closest approach and the smaller root from the product of the roots, which avoids the two
/// cancellations of the textbook formula (Haines et al., Ray Tracing Gems, chapter 7, 2019).
template <typename Vec>
Roots intersect_unit_quadric(Vec origin, Vec direction) {
  const float a = glm::dot(direction, direction);
  const float b = -glm::dot(origin, direction);
  const Vec closest = origin + (b / a) * direction;
  const float discriminant = 1 - glm::dot(closest, closest);
  const float q = b + std::copysign(std::sqrt(a * discriminant), b);
  const float c = glm::dot(origin, origin) - 1;
  const float t0 = c / q;
  const float t1 = q / a;
  return {std::min(t0, t1), std::max(t0, t1)};
}

float angle_share(float x, float y) {
  const float share = fast_atan2(y, x) * (0.5f * kInvPi);
  return share < 0 ? share + 1 : share;
}

class Sphere final : public ShapeOf<Sphere> {
 public:
  Sphere(const ShapeDescription& description, const Mat4& to_world)
      : ShapeOf(description, to_world) {
    radius_ = std::cbrt(std::abs(linear_.determinant));
    const Mat3 gram = glm::transpose(linear_.matrix) * linear_.matrix;
    const Mat3 deviation = gram - Mat3(sqr(radius_));
    float largest = 0;
    for (int i = 0; i < 3; ++i) largest = std::max(largest, max_component(glm::abs(deviation[i])));
    is_round_ = largest < 1e-5f * sqr(radius_);
    set_area(4 * kPi, is_round_ ? 4 * kPi * sqr(radius_) : ellipsoid_area());
  }

  static float intersect_local(Vec3 origin, Vec3 direction, float t_min, float t_max) {
    const Roots roots = intersect_unit_quadric(origin, direction);
    const float t = roots.near > t_min ? roots.near : roots.far;
    return (t > t_min) & (t < t_max) ? t : kInfinity;
  }

  float sample_seen_from(Vec3 reference, Vec2 u, SurfacePoint& point) const override {
    const Cone cone = cone_from(reference);
    if (!cone.valid) return Shape::sample_seen_from(reference, u, point);
    // The point where a direction at angle θ in the cone first meets the sphere lies at angle α
    // around the centre: α = asin(d/r·sinθ) - θ.
    const float one_minus_cos = u.x * cone.one_minus_cos_max;
    const float sin2_theta = one_minus_cos * (2 - one_minus_cos);
    const float sin2_alpha_theta = std::min(1.0f, sin2_theta / cone.sin2_max);
    const float cos_theta = 1 - one_minus_cos;
    const float cos_alpha =
        std::sqrt(sin2_theta * sin2_alpha_theta) + cos_theta * std::sqrt(1 - sin2_alpha_theta);
    const float sin_alpha = safe_sqrt(1 - sqr(cos_alpha));
    const float phi = 2 * kPi * u.y;
    const Frame frame = Frame::from_normal(cone.axis);
    const Vec3 normal =
        frame.to_world({sin_alpha * std::cos(phi), sin_alpha * std::sin(phi), cos_alpha});
    fill_local(glm::normalize(linear_.inverse * normal), point);
    return cone.pdf();
  }

  float pdf_seen_from(Vec3 reference, const SurfacePoint& point) const override {
    const Cone cone = cone_from(reference);
    if (!cone.valid) return Shape::pdf_seen_from(reference, point);
    const bool faces =
        glm::dot(normal_sign_ * point.geometric_normal, reference - point.position) > 0;
    return faces ? cone.pdf() : 0.0f;
  }

 private:
  struct Cone {
    bool valid = false;  // the reference is clearly outside a round sphere
    Vec3 axis{0};        // from the centre to the reference
    float sin2_max = 0;
    float one_minus_cos_max = 0;

    float pdf() const { return 0.5f * kInvPi / one_minus_cos_max; }
  };

  Cone cone_from(Vec3 reference) const {
    Cone cone;
    const Vec3 to_reference = reference - origin_;
    const float squared = length_squared(to_reference);
    cone.valid = is_round_ && squared > sqr(radius_) * (1 + 1e-5f);
    if (!cone.valid) return cone;
    cone.axis = to_reference / std::sqrt(squared);
    cone.sin2_max = sqr(radius_) / squared;
    cone.one_minus_cos_max = cone.sin2_max / (1 + safe_sqrt(1 - cone.sin2_max));
    return cone;
  }

  /// Midpoint rule in z and φ.
  float ellipsoid_area() const {
    constexpr int kRows = 512, kColumns = 128;
    double sum = 0;
    for (int row = 0; row < kRows; ++row) {
      const float z = -1 + (row + 0.5f) * 2 / kRows;
      const float r = safe_sqrt(1 - z * z);
      for (int column = 0; column < kColumns; ++column) {
        const float phi = (column + 0.5f) * 2 * kPi / kColumns;
        sum += area_factor({r * std::cos(phi), r * std::sin(phi), z});
      }
    }
    return static_cast<float>(4 * std::numbers::pi * sum / (kRows * kColumns));
  }

  Vec3 project_local(Vec3 p) const override { return glm::normalize(p); }
  Vec3 normal_local(Vec3 p) const override { return p; }
  Vec3 normal_derivative_local(Vec3 displacement) const override { return displacement; }
  Parametrisation parametrise(Vec3 p) const override {
    const float r = std::sqrt(sqr(p.x) + sqr(p.y));
    const Vec2 around = r > 0 ? Vec2(p.x, p.y) / r : Vec2(1, 0);
    return {Vec2(angle_share(p.x, p.y), fast_atan2(r, p.z) * kInvPi), 2 * kPi * Vec3(-p.y, p.x, 0),
            kPi * Vec3(p.z * around.x, p.z * around.y, -r)};
  }
  Vec3 sample_local(Vec2 u) const override { return square_to_sphere(u); }
  Bounds bounds_around_origin() const override {
    const Mat3 rows = glm::transpose(linear_.matrix);
    const Vec3 extent(glm::length(rows[0]), glm::length(rows[1]), glm::length(rows[2]));
    return {-extent, extent};
  }

  float radius_;
  bool is_round_;
};

/// Bounds of the unit circle in z = 0 under a linear map.
Bounds circle_bounds(const Mat3& matrix) {
  const Vec3 extent = glm::sqrt(matrix[0] * matrix[0] + matrix[1] * matrix[1]);
  return {-extent, extent};
}

class Disk final : public ShapeOf<Disk> {
 public:
  Disk(const ShapeDescription& description, const Mat4& to_world) : ShapeOf(description, to_world) {
    set_area(kPi, kPi * area_factor({0, 0, 1}));
  }

  static float intersect_local(Vec3 origin, Vec3 direction, float t_min, float t_max) {
    const float t = -origin.z / direction.z;
    const Vec2 p = Vec2(origin) + t * Vec2(direction);
    return (t > t_min) & (t < t_max) & (glm::dot(p, p) <= 1) ? t : kInfinity;
  }

 private:
  Vec3 project_local(Vec3 p) const override { return {p.x, p.y, 0}; }
  Vec3 normal_local(Vec3) const override { return {0, 0, 1}; }
  Vec3 normal_derivative_local(Vec3) const override { return Vec3(0); }
  Parametrisation parametrise(Vec3 p) const override {
    const float r = std::sqrt(sqr(p.x) + sqr(p.y));
    const Vec2 around = r > 0 ? Vec2(p.x, p.y) / r : Vec2(1, 0);
    return {Vec2(r, angle_share(p.x, p.y)), Vec3(around, 0), 2 * kPi * Vec3(-p.y, p.x, 0)};
  }
  Vec3 sample_local(Vec2 u) const override { return Vec3(square_to_disk(u), 0); }
  Bounds bounds_around_origin() const override { return circle_bounds(linear_.matrix); }
};

class Cylinder final : public ShapeOf<Cylinder> {
 public:
  Cylinder(const ShapeDescription& description, const Mat4& to_world)
      : ShapeOf(description, to_world) {
    constexpr int kSteps = 1024;  // of the rectangle rule, exact for periodic functions this smooth
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) {
      const float phi = i * 2 * kPi / kSteps;
      sum += area_factor({std::cos(phi), std::sin(phi), 0});
    }
    set_area(2 * kPi, static_cast<float>(2 * std::numbers::pi * sum / kSteps));
  }

  static float intersect_local(Vec3 origin, Vec3 direction, float t_min, float t_max) {
    const Roots roots = intersect_unit_quadric(Vec2(origin), Vec2(direction));
    const auto if_on_side = [&](float t) {
      const float z = origin.z + t * direction.z;
      return (t > t_min) & (t < t_max) & (z >= 0) & (z <= 1) ? t : kInfinity;
    };
    return std::min(if_on_side(roots.near), if_on_side(roots.far));
  }

 private:
  Vec3 project_local(Vec3 p) const override {
    return Vec3(glm::normalize(Vec2(p)), std::clamp(p.z, 0.0f, 1.0f));
  }
  Vec3 normal_local(Vec3 p) const override { return {p.x, p.y, 0}; }
  Vec3 normal_derivative_local(Vec3 displacement) const override {
    return {displacement.x, displacement.y, 0};
  }
  Parametrisation parametrise(Vec3 p) const override {
    return {Vec2(angle_share(p.x, p.y), p.z), 2 * kPi * Vec3(-p.y, p.x, 0), Vec3(0, 0, 1)};
  }
  Vec3 sample_local(Vec2 u) const override {
    const float phi = 2 * kPi * u.x;
    return {std::cos(phi), std::sin(phi), u.y};
  }
  Bounds bounds_around_origin() const override {
    const Bounds circle = circle_bounds(linear_.matrix);
    Bounds bounds = circle;
    bounds.extend({circle.lower + linear_.matrix[2], circle.upper + linear_.matrix[2]});
    return bounds;
  }
};

}  // namespace

AnalyticShape::AnalyticShape(const ShapeDescription& description, const Mat4& to_world)
    : linear_(to_world, description),
      origin_(to_world[3]),
      normal_sign_(description.flip_normals ? -1.0f : 1.0f) {}

void AnalyticShape::fill(const Ray& ray, const Hit& hit, SurfacePoint& point) const {
  const Vec3 local = to_local(ray.origin) + hit.t * (linear_.inverse * ray.direction);
  fill_local(project_local(local), point);
}

void AnalyticShape::fill_local(Vec3 local, SurfacePoint& point) const {
  const Vec3 relative = linear_.matrix * local;
  point.primitive = 0;
  point.position = origin_ + relative;
  const Vec3 scaled_normal = linear_.normal(normal_local(local));
  const float stretch =
      glm::length(scaled_normal);  // local distance per world distance along the normal
  point.geometric_normal = (normal_sign_ / stretch) * scaled_normal;

  if (is_parametrised) {
    const Parametrisation parametrisation = parametrise(local);
    point.uv = parametrisation.uv;
    point.dpdu = linear_.matrix * parametrisation.dpdu;
    point.dpdv = linear_.matrix * parametrisation.dpdv;
    point.frame = Frame::from_normal_and_tangent(point.geometric_normal, point.dpdu);
  } else {
    point.frame = Frame::from_normal(point.geometric_normal);
  }

  // The world position is rounded; then the intersection that starts there rounds in local space,
  // where the matrix product and the equation each lose digits of the terms they sum.
  const Vec3 distance = glm::abs(relative);
  const Vec3 terms = glm::abs(linear_.inverse[0]) * distance.x +
                     glm::abs(linear_.inverse[1]) * distance.y +
                     glm::abs(linear_.inverse[2]) * distance.z;
  const float world_magnitude = max_component(glm::abs(origin_) + distance);
  point.offset = kFloatEpsilon * (4 * world_magnitude + 8 * max_component(terms) / stretch);
}

Vec3 AnalyticShape::normal_derivative(const Hit&, Vec3 position, Vec3 displacement) const {
  const Vec3 scaled_normal = linear_.normal(normal_local(project_local(to_local(position))));
  const Vec3 change = linear_.normal(normal_derivative_local(linear_.inverse * displacement));
  return normal_sign_ * derivative_of_unit(scaled_normal, change);
}

float AnalyticShape::sample_area(Vec2 u, SurfacePoint& point) const {
  const Vec3 local = sample_local(u);
  fill_local(local, point);
  return 1 / (local_area_ * area_factor(normal_local(local)));
}

float AnalyticShape::pdf_area(const SurfacePoint& point) const {
  const Vec3 local = project_local(to_local(point.position));
  return 1 / (local_area_ * area_factor(normal_local(local)));
}

Bounds AnalyticShape::bounds() const {
  const Bounds relative = bounds_around_origin();
  Bounds bounds{origin_ + relative.lower, origin_ + relative.upper};
  // Room for the rounding of positions on the surface.
  const Vec3 margin =
      4 * kFloatEpsilon * (glm::abs(origin_) + glm::max(-relative.lower, relative.upper));
  bounds.lower -= margin;
  bounds.upper += margin;
  return bounds;
}

namespace {

std::unique_ptr<AnalyticShape> make_unchecked(const ShapeDescription& description,
                                              const Mat4& to_world) {
  if (std::holds_alternative<SphereShape>(description.geometry)) {
    return std::make_unique<Sphere>(description, to_world);
  }
  if (std::holds_alternative<DiskShape>(description.geometry)) {
    return std::make_unique<Disk>(description, to_world);
  }
  if (std::holds_alternative<CylinderShape>(description.geometry)) {
    return std::make_unique<Cylinder>(description, to_world);
  }
  throw Error("{} is an instance; it has no geometry of its own", shape_label(description));
}

}  // namespace

std::unique_ptr<AnalyticShape> make_analytic_shape(const ShapeDescription& description,
                                                   const Mat4& to_world) {
  auto shape = make_unchecked(description, to_world);
  const Bounds bounds = shape->bounds();
  if (!is_within(bounds.lower, kLargestCoordinate) ||
      !is_within(bounds.upper, kLargestCoordinate)) {
    throw Error("{} reaches farther than {} from the origin; move or scale it",
                shape_label(description), kLargestCoordinate);
  }
  return shape;
}

}  // namespace guidelight

#include "renderer/scene/shape.h"

#include "renderer/error.h"
#include "renderer/scene/analytic_shape.h"
#include "renderer/scene/shape_transform.h"
#include "renderer/scene/triangle_mesh.h"

namespace guidelight {

std::string shape_label(const ShapeDescription& description) {
  return description.line > 0
             ? fmt::format("Shape '{}' (line {})", description.name, description.line)
             : fmt::format("Shape '{}'", description.name);
}

bool is_singular(const Mat4& to_world) {
  const glm::dmat3 m(to_world);
  const double volume = glm::length(m[0]) * glm::length(m[1]) * glm::length(m[2]);
  return std::abs(glm::determinant(m)) <= 1e-8 * volume;
}

LinearTransform::LinearTransform(const Mat4& to_world, const ShapeDescription& description) {
  const glm::dmat3 m(to_world);
  const double det = glm::determinant(m);
  if (!std::isfinite(det) || !is_finite(Vec3(to_world[3])) || is_singular(to_world)) {
    throw Error(
        "{} has a transform that is singular or not finite; give it a transform that can be "
        "inverted",
        shape_label(description));
  }
  matrix = Mat3(m);
  inverse = Mat3(glm::inverse(m));
  determinant = static_cast<float>(det);
}

namespace {

/// Density per solid angle at `reference` of a point with this density per area.
float pdf_solid_angle(Vec3 reference, const SurfacePoint& point, float pdf_area) {
  const Vec3 to_reference = reference - point.position;
  const float squared = length_squared(to_reference);
  const float cosine =
      std::abs(glm::dot(point.geometric_normal, to_reference)) / std::sqrt(squared);
  return cosine > 0 && squared > 0 ? pdf_area * squared / cosine : 0.0f;
}

}  // namespace

float Shape::sample_seen_from(Vec3 reference, Vec2 u, SurfacePoint& point) const {
  const float pdf_area = sample_area(u, point);
  return pdf_solid_angle(reference, point, pdf_area);
}

float Shape::pdf_seen_from(Vec3 reference, const SurfacePoint& point) const {
  return pdf_solid_angle(reference, point, pdf_area(point));
}

std::unique_ptr<Shape> make_shape(const ShapeDescription& description, const Mat4& parent) {
  const Mat4 to_world = parent * description.to_world;
  if (std::holds_alternative<MeshShape>(description.geometry)) {
    return std::make_unique<TriangleMesh>(description, to_world);
  }
  return make_analytic_shape(description, to_world);
}

}  // namespace guidelight

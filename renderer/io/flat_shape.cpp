#include "renderer/io/flat_shape.h"

#include "renderer/scene/shape.h"
#include "renderer/scene/shape_transform.h"

namespace guidelight {
namespace {

/// Extent along the axes of the shape's own space.
Vec3 extent_of(const ShapeDescription& shape) {
  if (std::holds_alternative<DiskShape>(shape.geometry)) return {2, 2, 0};
  const auto* mesh = std::get_if<MeshShape>(&shape.geometry);
  if (!mesh) return Vec3(2);
  Bounds bounds;
  for (const Vec3 p : mesh->mesh->positions) bounds.extend(p);
  return bounds.upper - bounds.lower;
}

}  // namespace

bool keep_drawable(ShapeDescription& shape) {
  Mat4& to_world = shape.to_world;
  if (!is_singular(to_world)) return true;
  const Vec3 extent = extent_of(shape);
  for (int axis = 0; axis < 3; ++axis) {
    if (extent[axis] > 0) continue;
    const Vec3 normal = glm::cross(Vec3(to_world[(axis + 1) % 3]), Vec3(to_world[(axis + 2) % 3]));
    if (!(length_squared(normal) > 0)) return false;
    to_world[axis] = Vec4(glm::normalize(normal), 0);
    return !is_singular(to_world);
  }
  return false;
}

}  // namespace guidelight

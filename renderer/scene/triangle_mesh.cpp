#include "renderer/scene/triangle_mesh.h"

#include <algorithm>

#include "renderer/error.h"
#include "renderer/sampling/warp.h"
#include "renderer/scene/reach.h"
#include "renderer/scene/shape_transform.h"

namespace guidelight {

namespace {

void check_mesh(const ShapeDescription& description, const Mesh& mesh) {
  const std::string label = shape_label(description);
  const size_t vertices = mesh.positions.size();
  if (mesh.triangles.empty()) {
    throw Error("{} has no triangles; remove it or give it a mesh with faces", label);
  }
  for (const auto& triangle : mesh.triangles) {
    for (const uint32_t index : triangle) {
      if (index >= vertices) {
        throw Error("{} refers to vertex {} of {}; repair the mesh file", label, index, vertices);
      }
    }
  }
  const auto check_size = [&](size_t size, const char* what) {
    if (size != 0 && size != vertices) {
      throw Error("{} has {} {} for {} vertices; repair the mesh file", label, size, what,
                  vertices);
    }
  };
  check_size(mesh.normals.size(), "normals");
  check_size(mesh.uvs.size(), "texture coordinates");
  check_size(mesh.colors.size(), "vertex colours");
  const auto uv_is_finite = [](Vec2 uv) { return std::isfinite(uv.x) && std::isfinite(uv.y); };
  if (!std::ranges::all_of(mesh.uvs, uv_is_finite)) {
    throw Error("{} has texture coordinates that are not finite; repair the mesh file", label);
  }
  if (!std::ranges::all_of(mesh.colors, is_finite)) {
    throw Error("{} has vertex colours that are not finite; repair the mesh file", label);
  }
}

/// Unit vector, or zero where there is no direction; safe for very short vectors.
Vec3 unit_or_zero(Vec3 v) {
  float squared = length_squared(v);
  if (squared < 1e-30f) {
    const float largest = max_component(glm::abs(v));
    if (!(largest > 0)) return Vec3(0);
    v /= largest;
    squared = length_squared(v);
  }
  return v / std::sqrt(squared);
}

double triangle_area(Vec3 a, Vec3 b, Vec3 c) {
  return 0.5 *
         glm::length(glm::cross(glm::dvec3(b) - glm::dvec3(a), glm::dvec3(c) - glm::dvec3(a)));
}

}  // namespace

TriangleMesh::TriangleMesh(const ShapeDescription& description, const Mat4& to_world)
    : mesh_(std::get<MeshShape>(description.geometry).mesh) {
  if (!mesh_) throw Error("{} has no mesh; give it one", shape_label(description));
  check_mesh(description, *mesh_);
  const LinearTransform transform(to_world, description);
  orientation_ = (transform.determinant < 0) != description.flip_normals ? -1.0f : 1.0f;

  positions_.reserve(mesh_->positions.size() + kPadding);
  for (const Vec3 p : mesh_->positions) {
    const Vec3 world = transform_point(to_world, p);
    if (!is_within(world, kLargestCoordinate)) {
      throw Error(
          "{} has a vertex that is not finite or farther than {} from the origin; repair or scale "
          "it",
          shape_label(description), kLargestCoordinate);
    }
    positions_.push_back(world);
    bounds_.extend(world);
  }
  positions_.resize(positions_.size() + kPadding, Vec3(0));

  normals_.reserve(mesh_->normals.size());
  const float normal_sign = description.flip_normals ? -1.0f : 1.0f;
  for (const Vec3 n : mesh_->normals) {
    const Vec3 world = normal_sign * transform.normal(n);
    normals_.push_back(is_finite(world) ? unit_or_zero(world) : Vec3(0));
  }
  measure();
  if (is_flat()) normals_.clear();
}

/// True if the vertex normals say no more than the faces themselves.
bool TriangleMesh::is_flat() const {
  if (normals_.empty()) return true;
  for (size_t i = 0; i < triangles().size(); ++i) {
    for (const uint32_t vertex : triangles()[i]) {
      if (glm::dot(normals_[vertex], faces_[i].normal) < 1 - 1e-6f) return false;
    }
  }
  return true;
}

void TriangleMesh::measure() {
  std::vector<float> areas;
  areas.reserve(triangles().size());
  for (const auto& [a, b, c] : triangles()) {
    areas.push_back(static_cast<float>(triangle_area(positions_[a], positions_[b], positions_[c])));
  }
  triangle_distribution_ = DiscreteDistribution(areas);
  area_ = static_cast<float>(triangle_distribution_.total());
  inverse_area_ = area_ > 0 ? 1 / area_ : 0.0f;
  faces_.reserve(triangles().size());
  for (const auto& triangle : triangles()) faces_.push_back(measure_face(triangle));
}

TriangleMesh::Face TriangleMesh::measure_face(const std::array<uint32_t, 3>& triangle) const {
  const auto [a, b, c] = triangle;
  const Vec3 p0 = positions_[a];
  const Vec3 p1 = positions_[b];
  const Vec3 p2 = positions_[c];
  Vec3 normal = orientation_ * unit_or_zero(glm::cross(p1 - p0, p2 - p0));
  if (normal == Vec3(0)) normal = {0, 0, 1};  // no area: any normal will do
  // Normals in the file are given on purpose, a winding often is not: they say where outside is.
  if (!normals_.empty() && glm::dot(normal, normals_[a] + normals_[b] + normals_[c]) < 0) {
    normal = -normal;
  }
  // Rounding of the interpolated position and of the ray-triangle test that starts there: the first
  // grows with the coordinates, the second with the distances to the vertices.
  const Vec3 lower = glm::min(p0, glm::min(p1, p2));
  const Vec3 upper = glm::max(p0, glm::max(p1, p2));
  const float extent = max_component(upper - lower);
  const float magnitude = max_component(glm::max(-lower, upper));
  return {normal, kFloatEpsilon * (4 * extent + 8 * magnitude)};
}

size_t TriangleMesh::bytes() const {
  return sizeof(*this) + std::span(positions_).size_bytes() + std::span(normals_).size_bytes() +
         std::span(faces_).size_bytes() + sizeof(float) * triangle_distribution_.size();
}

void TriangleMesh::fill(const Ray&, const Hit& hit, SurfacePoint& point) const {
  fill_triangle(hit.primitive, hit.barycentric, point);
}

float TriangleMesh::sample_area(Vec2 u, SurfacePoint& point) const {
  const auto triangle = triangle_distribution_.sample(u.x);
  fill_triangle(triangle.index, square_to_triangle({triangle.remapped, u.y}), point);
  return inverse_area_;
}

void TriangleMesh::fill_triangle(uint32_t triangle, Vec2 barycentric, SurfacePoint& point) const {
  const std::array<uint32_t, 3>& vertices = mesh_->triangles[triangle];
  const auto [a, b, c] = vertices;
  const float b1 = barycentric.x;
  const float b2 = barycentric.y;
  const Vec3 p0 = positions_[a];
  point.primitive = triangle;
  point.position = p0 + b1 * (positions_[b] - p0) + b2 * (positions_[c] - p0);
  point.geometric_normal = faces_[triangle].normal;
  point.offset = faces_[triangle].offset;

  Vec3 shading_normal = point.geometric_normal;
  if (!normals_.empty()) {
    const Vec3 n = (1 - b1 - b2) * normals_[a] + b1 * normals_[b] + b2 * normals_[c];
    const float squared = length_squared(n);
    if (squared > 1e-12f) shading_normal = n / std::sqrt(squared);
  }
  if (is_parametrised) {
    parametrise(vertices, barycentric, shading_normal, point);
  } else {
    point.frame = Frame::from_normal(shading_normal);
  }
}

Vec3 TriangleMesh::normal_derivative(const Hit& hit, Vec3, Vec3 displacement) const {
  if (normals_.empty()) return Vec3(0);
  const auto [a, b, c] = mesh_->triangles[hit.primitive];
  const Vec3 edge1 = positions_[b] - positions_[a];
  const Vec3 edge2 = positions_[c] - positions_[a];
  const Vec3 scaled = glm::cross(edge1, edge2);
  const float squared = length_squared(scaled);
  const Vec3 n1 = normals_[b] - normals_[a];
  const Vec3 n2 = normals_[c] - normals_[a];
  const Vec3 normal = normals_[a] + hit.barycentric.x * n1 + hit.barycentric.y * n2;
  if (!(squared > 0) || !(length_squared(normal) > 1e-12f)) return Vec3(0);
  // The displacement in barycentric coordinates.
  const float b1 = glm::dot(glm::cross(displacement, edge2), scaled) / squared;
  const float b2 = glm::dot(glm::cross(edge1, displacement), scaled) / squared;
  return derivative_of_unit(normal, b1 * n1 + b2 * n2);
}

void TriangleMesh::parametrise(const std::array<uint32_t, 3>& triangle, Vec2 barycentric,
                               Vec3 shading_normal, SurfacePoint& point) const {
  const auto [a, b, c] = triangle;
  const float b1 = barycentric.x;
  const float b2 = barycentric.y;
  if (!mesh_->colors.empty()) {
    point.vertex_color =
        (1 - b1 - b2) * mesh_->colors[a] + b1 * mesh_->colors[b] + b2 * mesh_->colors[c];
  }
  point.uv = barycentric;
  point.dpdu = point.dpdv = Vec3(0);
  if (mesh_->uvs.empty()) {
    point.frame = Frame::from_normal(shading_normal);
    return;
  }
  const Vec2 uv0 = mesh_->uvs[a];
  const Vec2 duv1 = mesh_->uvs[b] - uv0;
  const Vec2 duv2 = mesh_->uvs[c] - uv0;
  point.uv = uv0 + b1 * duv1 + b2 * duv2;
  const float determinant = duv1.x * duv2.y - duv1.y * duv2.x;
  if (std::abs(determinant) > 1e-30f) {
    const Vec3 edge1 = positions_[b] - positions_[a];
    const Vec3 edge2 = positions_[c] - positions_[a];
    point.dpdu = (duv2.y * edge1 - duv1.y * edge2) / determinant;
    point.dpdv = (duv1.x * edge2 - duv2.x * edge1) / determinant;
  }
  point.frame = Frame::from_normal_and_tangent(shading_normal, point.dpdu);
}

}  // namespace guidelight

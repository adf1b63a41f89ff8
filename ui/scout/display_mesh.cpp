#include "ui/scout/display_mesh.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "renderer/scene/shape.h"

namespace guidelight {
namespace {

constexpr int kSectors = 32;  // around a sphere, disk or cylinder
constexpr int kRings = 16;    // from pole to pole of a sphere

uint32_t pack_bytes(Vec3 v, float scale, uint32_t fourth) {
  const auto byte = [&](float x) {
    return static_cast<uint32_t>(static_cast<int>(std::lround(x * scale))) & 255u;
  };
  return byte(v.x) | byte(v.y) << 8 | byte(v.z) << 16 | fourth << 24;
}

Vec3 around_z(int sector, float radius, float z) {
  const float angle = 2 * kPi * static_cast<float>(sector) / kSectors;
  return {radius * std::cos(angle), radius * std::sin(angle), z};
}

/// Gathers the triangles of one shape after another.
class Tessellator {
 public:
  Tessellator(const SceneDescription& scene, std::vector<bool> as_boxes)
      : scene_(scene), as_boxes_(std::move(as_boxes)), bounds_(scene.groups.size()) {}

  void add(const ShapeDescription& shape, const Mat4& parent) {
    to_world_ = parent * shape.to_world;
    normal_to_world_ = glm::transpose(glm::inverse(Mat3(to_world_)));
    const DisplayMaterial material = display_material(scene_, shape.bsdf);
    const uint32_t alpha = shape.radiance ? 255 : material.clear ? 0 : 128;
    const Color color = shape.radiance ? Color(1.0f, 0.93f, 0.75f) : material.color;
    color_ = pack_bytes(color, 255, alpha);
    std::visit([this](const auto& geometry) { tessellate(geometry); }, shape.geometry);
  }

  DisplayMesh take() { return std::move(mesh_); }

 private:
  void tessellate(const MeshShape& shape) {
    if (!shape.mesh) return;
    const Mesh& mesh = *shape.mesh;
    const bool smooth = !mesh.normals.empty();
    mesh_.vertices.reserve(mesh_.vertices.size() + 3 * mesh.triangles.size());
    for (const auto& [i, j, k] : mesh.triangles) {
      const Vec3 a = mesh.positions[i], b = mesh.positions[j], c = mesh.positions[k];
      const Vec3 flat = glm::cross(b - a, c - a);
      add_vertex(a, smooth ? mesh.normals[i] : flat);
      add_vertex(b, smooth ? mesh.normals[j] : flat);
      add_vertex(c, smooth ? mesh.normals[k] : flat);
    }
  }

  void tessellate(const SphereShape&) {
    const auto on_sphere = [](int ring, int sector) {
      const float angle = kPi * static_cast<float>(ring) / kRings;
      return around_z(sector, std::sin(angle), std::cos(angle));
    };
    for (int ring = 0; ring < kRings; ++ring) {
      for (int sector = 0; sector < kSectors; ++sector) {
        const Vec3 a = on_sphere(ring, sector), b = on_sphere(ring + 1, sector);
        const Vec3 c = on_sphere(ring + 1, sector + 1), d = on_sphere(ring, sector + 1);
        add_quad({a, b, c, d}, {a, b, c, d});
      }
    }
  }

  void tessellate(const DiskShape&) {
    constexpr Vec3 kNormal(0, 0, 1);
    for (int sector = 0; sector < kSectors; ++sector) {
      add_vertex(Vec3(0), kNormal);
      add_vertex(around_z(sector, 1, 0), kNormal);
      add_vertex(around_z(sector + 1, 1, 0), kNormal);
    }
  }

  void tessellate(const CylinderShape&) {
    for (int sector = 0; sector < kSectors; ++sector) {
      const Vec3 a = around_z(sector, 1, 0), b = around_z(sector + 1, 1, 0);
      const Vec3 up(0, 0, 1);
      add_quad({a, b, b + up, a + up}, {a, b, b, a});
    }
  }

  void tessellate(const InstanceShape& instance) {
    const Mat4 group_to_world = to_world_;
    if (as_boxes_[instance.group]) {
      ++mesh_.boxes;
      add_box(group_bounds(instance.group));
      return;
    }
    for (const ShapeDescription& shape : scene_.groups[instance.group].shapes) {
      add(shape, group_to_world);
    }
  }

  void add_box(const Bounds& bounds) {
    if (bounds.empty()) return;
    for (int axis = 0; axis < 3; ++axis) {
      for (const float side : {0.0f, 1.0f}) {
        const auto corner = [&](float u, float v) {
          Vec3 share;
          share[axis] = side;
          share[(axis + 1) % 3] = u;
          share[(axis + 2) % 3] = v;
          return glm::mix(bounds.lower, bounds.upper, share);
        };
        Vec3 n(0);
        n[axis] = 2 * side - 1;
        add_quad({corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)}, {n, n, n, n});
      }
    }
  }

  /// Of its shapes, when it is first asked for.
  const Bounds& group_bounds(int group) {
    if (!bounds_[group]) {
      bounds_[group].emplace();
      for (const ShapeDescription& shape : scene_.groups[group].shapes) {
        extend(*bounds_[group], shape);
      }
    }
    return *bounds_[group];
  }

  static void extend(Bounds& bounds, const ShapeDescription& shape) {
    const auto extend = [&](Vec3 p) { bounds.extend(transform_point(shape.to_world, p)); };
    if (const auto* mesh = std::get_if<MeshShape>(&shape.geometry)) {
      if (mesh->mesh) std::ranges::for_each(mesh->mesh->positions, extend);
      return;
    }
    for (int corner = 0; corner < 8; ++corner) {  // of a cube that holds every analytic shape
      extend(2.0f * Vec3(corner & 1, corner >> 1 & 1, corner >> 2) - 1.0f);
    }
  }

  void add_quad(const std::array<Vec3, 4>& corners, const std::array<Vec3, 4>& normals) {
    for (const int i : {0, 1, 2, 0, 2, 3}) add_vertex(corners[i], normals[i]);
  }

  void add_vertex(Vec3 position, Vec3 normal) {
    const Vec3 n = normal_to_world_ * normal;
    const float length = glm::length(n);
    mesh_.vertices.push_back({transform_point(to_world_, position),
                              pack_bytes(length > 0 ? n / length : Vec3(0, 0, 1), 127, 0), color_});
  }

  const SceneDescription& scene_;
  std::vector<bool> as_boxes_;  // per group
  std::vector<std::optional<Bounds>> bounds_;
  DisplayMesh mesh_;
  Mat4 to_world_{1.0f};
  Mat3 normal_to_world_{1.0f};
  uint32_t color_ = 0;
};

size_t triangles_of(const ShapeDescription& shape) {
  constexpr size_t kOfAnalyticShapes = 2 * kSectors * kRings;  // at most
  const auto* mesh = std::get_if<MeshShape>(&shape.geometry);
  if (!mesh) return kOfAnalyticShapes;
  return mesh->mesh ? mesh->mesh->triangles.size() : 0;
}

/// Which groups are shown as boxes.
std::vector<bool> groups_as_boxes(const SceneDescription& scene, size_t most_triangles) {
  std::vector<size_t> triangles(scene.groups.size(), 0);  // in all instances of a group
  std::vector<size_t> in_group(scene.groups.size(), 0);
  for (size_t i = 0; i < scene.groups.size(); ++i) {
    for (const ShapeDescription& shape : scene.groups[i].shapes) in_group[i] += triangles_of(shape);
  }
  size_t total = 0;
  for (const ShapeDescription& shape : scene.shapes) {
    const auto* instance = std::get_if<InstanceShape>(&shape.geometry);
    if (instance) triangles[instance->group] += in_group[instance->group];
    total += instance ? in_group[instance->group] : triangles_of(shape);
  }
  std::vector<bool> as_boxes(scene.groups.size(), false);
  while (total > most_triangles) {
    const auto heaviest = std::ranges::max_element(triangles);
    if (heaviest == triangles.end() || *heaviest == 0) break;
    as_boxes[heaviest - triangles.begin()] = true;
    total -= std::exchange(*heaviest, 0);
  }
  return as_boxes;
}

}  // namespace

DisplayMesh make_display_mesh(const SceneDescription& scene, size_t most_triangles) {
  Tessellator tessellator(scene, groups_as_boxes(scene, most_triangles));
  for (const ShapeDescription& shape : scene.shapes) tessellator.add(shape, Mat4(1));
  return tessellator.take();
}

}  // namespace guidelight

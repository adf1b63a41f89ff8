#include "ui/scout/display_mesh.h"

#include <cmath>

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
  explicit Tessellator(const SceneDescription& scene) : scene_(scene) {}

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
    for (const ShapeDescription& shape : scene_.groups[instance.group].shapes) {
      add(shape, group_to_world);
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
  DisplayMesh mesh_;
  Mat4 to_world_{1.0f};
  Mat3 normal_to_world_{1.0f};
  uint32_t color_ = 0;
};

}  // namespace

DisplayMesh make_display_mesh(const SceneDescription& scene) {
  Tessellator tessellator(scene);
  for (const ShapeDescription& shape : scene.shapes) tessellator.add(shape, Mat4(1));
  return tessellator.take();
}

}  // namespace guidelight

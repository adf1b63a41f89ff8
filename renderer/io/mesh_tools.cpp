#include "renderer/io/mesh_tools.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <map>
#include <span>
#include <unordered_map>

#include "renderer/error.h"

namespace guidelight {
namespace {

/// Not normalised: twice the area.
Vec3 face_vector(const Mesh& mesh, const std::array<uint32_t, 3>& triangle) {
  const Vec3 a = mesh.positions[triangle[0]];
  return glm::cross(mesh.positions[triangle[1]] - a, mesh.positions[triangle[2]] - a);
}

Vec3 unit_or(Vec3 v, Vec3 fallback) {
  const float squared = length_squared(v);
  return squared > 0 && std::isfinite(squared) ? v / std::sqrt(squared) : fallback;
}

/// Angle of the triangle at its corner; 0 where it is degenerate.
float corner_angle(const Mesh& mesh, const std::array<uint32_t, 3>& triangle, int corner) {
  const Vec3 p = mesh.positions[triangle[corner]];
  const Vec3 a = unit_or(mesh.positions[triangle[(corner + 1) % 3]] - p, Vec3(0));
  const Vec3 b = unit_or(mesh.positions[triangle[(corner + 2) % 3]] - p, Vec3(0));
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

/// All attributes of a vertex as words, missing ones as zeros.
using VertexKey = std::array<uint32_t, 11>;

struct VertexKeyHash {
  size_t operator()(const VertexKey& key) const {
    uint64_t hash = 0xcbf29ce484222325u;  // FNV-1a over words
    for (const uint32_t word : key) hash = (hash ^ word) * 0x100000001b3u;
    return hash ^ hash >> 32;
  }
};

VertexKey vertex_key(const Mesh& mesh, size_t i) {
  std::array<float, 11> values{};
  const auto store = [&](int at, const auto& list, int count) {
    if (list.empty()) return;
    for (int c = 0; c < count; ++c) values[at + c] = list[i][c] + 0.0f;  // -0 equals 0
  };
  store(0, mesh.positions, 3);
  store(3, mesh.normals, 3);
  store(6, mesh.uvs, 2);
  store(8, mesh.colors, 3);
  VertexKey key;
  std::memcpy(key.data(), values.data(), sizeof(key));
  return key;
}

template <typename T>
void keep(std::vector<T>& list, const std::vector<uint32_t>& kept) {
  if (list.empty()) return;
  for (size_t i = 0; i < kept.size(); ++i) list[i] = list[kept[i]];
  list.resize(kept.size());
  list.shrink_to_fit();
}

void keep_vertices(Mesh& mesh, const std::vector<uint32_t>& kept) {
  keep(mesh.positions, kept);
  keep(mesh.normals, kept);
  keep(mesh.uvs, kept);
  keep(mesh.colors, kept);
}

void renumber(Mesh& mesh, const std::vector<uint32_t>& renumbered) {
  for (std::array<uint32_t, 3>& triangle : mesh.triangles) {
    for (uint32_t& index : triangle) index = renumbered[index];
  }
}

void repair_normals(Mesh& mesh) {
  for (const std::array<uint32_t, 3>& triangle : mesh.triangles) {
    for (const uint32_t i : triangle) {
      Vec3& normal = mesh.normals[i];
      const float squared = length_squared(normal);
      if (std::abs(squared - 1) < 1e-5f) continue;
      normal = unit_or(normal, unit_or(face_vector(mesh, triangle), Vec3(0, 0, 1)));
    }
  }
}

}  // namespace

void compute_smooth_normals(Mesh& mesh) {
  mesh.normals.assign(mesh.positions.size(), Vec3(0));
  for (const std::array<uint32_t, 3>& triangle : mesh.triangles) {
    const Vec3 normal = unit_or(face_vector(mesh, triangle), Vec3(0));
    for (int corner = 0; corner < 3; ++corner) {
      mesh.normals[triangle[corner]] += normal * corner_angle(mesh, triangle, corner);
    }
  }
  for (Vec3& normal : mesh.normals) normal = unit_or(normal, Vec3(0, 0, 1));
}

void join_equal_vertices(Mesh& mesh) {
  std::unordered_map<VertexKey, uint32_t, VertexKeyHash> first;
  first.reserve(mesh.positions.size());
  std::vector<uint32_t> kept;                               // old index of each new vertex
  std::vector<uint32_t> renumbered(mesh.positions.size());  // new index of each old vertex
  for (uint32_t i = 0; i < mesh.positions.size(); ++i) {
    const auto [found, is_new] =
        first.try_emplace(vertex_key(mesh, i), static_cast<uint32_t>(kept.size()));
    if (is_new) kept.push_back(i);
    renumbered[i] = found->second;
  }
  keep_vertices(mesh, kept);
  renumber(mesh, renumbered);
}

void drop_unused_vertices(Mesh& mesh) {
  std::vector<uint32_t> renumbered(mesh.positions.size(), 0);  // first: 1 where used
  for (const std::array<uint32_t, 3>& triangle : mesh.triangles) {
    for (const uint32_t index : triangle) renumbered[index] = 1;
  }
  std::vector<uint32_t> kept;
  for (uint32_t i = 0; i < renumbered.size(); ++i) {
    if (!renumbered[i]) continue;
    renumbered[i] = static_cast<uint32_t>(kept.size());
    kept.push_back(i);
  }
  if (kept.size() == mesh.positions.size()) return;
  keep_vertices(mesh, kept);
  renumber(mesh, renumbered);
}

namespace {

struct FaceCorner {
  uint32_t triangle;
  int corner;
};

/// Triangles around a vertex that lie in one plane, or nearly.
struct Facet {
  Vec3 normal;    // unit, of the first
  Vec3 weighted;  // sum of normals times angles
};

/// The facets around a vertex; each triangle is one unless there are many, all of which would have
/// to be compared with all.
std::vector<Facet> facets_around(const Mesh& mesh, const std::vector<Vec3>& face_normals,
                                 std::span<const FaceCorner> corners) {
  constexpr size_t kMany = 256;
  constexpr float kCells = 64;  // per unit of the normal, below one degree
  std::vector<Facet> facets;
  std::map<std::array<int, 3>, size_t> by_cell;
  for (const FaceCorner& corner : corners) {
    const Vec3 normal = face_normals[corner.triangle];
    const Vec3 weighted =
        normal * corner_angle(mesh, mesh.triangles[corner.triangle], corner.corner);
    if (corners.size() > kMany) {
      const glm::ivec3 cell(glm::round(kCells * normal));
      const auto [known, is_new] = by_cell.try_emplace({cell.x, cell.y, cell.z}, facets.size());
      if (!is_new) {
        facets[known->second].weighted += weighted;
        continue;
      }
    }
    facets.push_back({normal, weighted});
  }
  return facets;
}

}  // namespace

void compute_creased_normals(Mesh& mesh, float max_angle) {
  const float min_cosine = std::cos(max_angle * kPi / 180);
  std::vector<std::vector<FaceCorner>> around(mesh.positions.size());
  std::vector<Vec3> face_normals;
  for (uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    face_normals.push_back(unit_or(face_vector(mesh, mesh.triangles[t]), Vec3(0)));
    for (int c = 0; c < 3; ++c) around[mesh.triangles[t][c]].push_back({t, c});
  }
  // Each corner takes the mean over the triangles within the angle, and so gets a vertex of its
  // own.
  Mesh split;
  std::vector<std::array<uint32_t, 3>> triangles = mesh.triangles;
  for (uint32_t vertex = 0; vertex < around.size(); ++vertex) {
    const std::vector<Facet> facets = facets_around(mesh, face_normals, around[vertex]);
    for (const FaceCorner& own : around[vertex]) {
      Vec3 normal(0);
      for (const Facet& facet : facets) {
        if (glm::dot(face_normals[own.triangle], facet.normal) >= min_cosine) {
          normal += facet.weighted;
        }
      }
      triangles[own.triangle][own.corner] = static_cast<uint32_t>(split.positions.size());
      split.positions.push_back(mesh.positions[vertex]);
      split.normals.push_back(unit_or(normal, Vec3(0, 0, 1)));
      if (!mesh.uvs.empty()) split.uvs.push_back(mesh.uvs[vertex]);
      if (!mesh.colors.empty()) split.colors.push_back(mesh.colors[vertex]);
    }
  }
  split.triangles = std::move(triangles);
  mesh = std::move(split);
  join_equal_vertices(mesh);
}

void check_mesh(Mesh& mesh, const std::string& name) {
  const size_t count = mesh.positions.size();
  const auto fits = [&](size_t size) { return size == 0 || size == count; };
  if (!fits(mesh.normals.size()) || !fits(mesh.uvs.size()) || !fits(mesh.colors.size())) {
    throw Error("Cannot use the mesh '{}': its vertex lists differ in length; export it again.",
                name);
  }
  for (const std::array<uint32_t, 3>& triangle : mesh.triangles) {
    for (const uint32_t index : triangle) {
      if (index >= count) {
        throw Error("Cannot use the mesh '{}': a triangle names vertex {} of {}; export it again.",
                    name, index, count);
      }
    }
  }
  for (size_t i = 0; i < count; ++i) {
    if (!is_finite(mesh.positions[i])) {
      throw Error("Cannot use the mesh '{}': vertex {} is not finite; export it again.", name, i);
    }
  }
  if (mesh.triangles.empty()) {
    throw Error("Cannot use the mesh '{}': it has no triangles; export it again.", name);
  }
  if (!mesh.normals.empty()) repair_normals(mesh);
  // Exporters write NaN where a surface has no parametrisation.
  for (Vec2& uv : mesh.uvs) uv = is_finite(Vec3(uv, 0)) ? uv : Vec2(0);
  for (Color& color : mesh.colors) color = is_finite(color) ? color : Color(1);
}

std::shared_ptr<const Mesh> make_rectangle_mesh() {
  auto mesh = std::make_shared<Mesh>();
  mesh->positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  mesh->normals.assign(4, Vec3(0, 0, 1));
  mesh->uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  mesh->triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

std::shared_ptr<const Mesh> make_cube_mesh() {
  auto mesh = std::make_shared<Mesh>();
  for (int axis = 0; axis < 3; ++axis) {
    for (const float side : {-1.0f, 1.0f}) {
      Vec3 normal(0), u(0);
      normal[axis] = side;
      u[(axis + 1) % 3] = side;
      const Vec3 v = glm::cross(normal, u);
      const auto base = static_cast<uint32_t>(mesh->positions.size());
      for (const Vec2 corner : {Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)}) {
        mesh->positions.push_back(normal + (2 * corner.x - 1) * u + (2 * corner.y - 1) * v);
        mesh->normals.push_back(normal);
        mesh->uvs.push_back(corner);
      }
      mesh->triangles.push_back({base, base + 1, base + 2});
      mesh->triangles.push_back({base, base + 2, base + 3});
    }
  }
  return mesh;
}

}  // namespace guidelight

#include "ui/photons/density_mesh.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <unordered_map>

#include "renderer/sampling/hash_position.h"
#include "ui/histogram.h"
#include "ui/widgets.h"

namespace guidelight {
namespace {

using Vertex = DisplayMesh::Vertex;

constexpr int kMostParts = 128;  // along an edge

float area_of(const Vertex* corners) {
  return 0.5f * glm::length(glm::cross(corners[1].position - corners[0].position,
                                       corners[2].position - corners[0].position));
}

/// The n² equal parts of a triangle, which has the normal and colour of its corners.
void divide(const Vertex* corners, int n, std::vector<Vertex>& parts) {
  const Vec3 a = corners[0].position;
  const Vec3 along = (corners[1].position - a) / static_cast<float>(n);
  const Vec3 across = (corners[2].position - a) / static_cast<float>(n);
  const auto add = [&](int i, int j) {
    Vertex vertex = corners[2 * i > n ? 1 : 2 * j > n ? 2 : 0];  // the nearest corner's normal
    vertex.position = a + static_cast<float>(i) * along + static_cast<float>(j) * across;
    parts.push_back(vertex);
  };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; i + j < n; ++j) {
      add(i, j);
      add(i + 1, j);
      add(i, j + 1);
      if (i + j + 1 == n) continue;
      add(i + 1, j);
      add(i + 1, j + 1);
      add(i, j + 1);
    }
  }
}

Vec3 flat_normal(const Vertex* corners) {
  const Vec3 normal = glm::cross(corners[1].position - corners[0].position,
                                 corners[2].position - corners[0].position);
  const float length = glm::length(normal);
  return length > 0 ? normal / length : Vec3(0, 0, 1);
}

/// The density at each vertex. Triangles share places, where it is searched for once.
std::vector<float> densities(const DisplayMesh& mesh, const PhotonSearch& photons) {
  std::unordered_map<uint64_t, float> known;
  std::vector<float> result;
  result.reserve(mesh.vertices.size());
  for (size_t first = 0; first < mesh.vertices.size(); first += 3) {
    const Vec3 normal = flat_normal(&mesh.vertices[first]);
    const uint64_t facing = hash_position(glm::round(16.0f * normal));
    for (size_t i = first; i < first + 3; ++i) {
      const Vec3 position = mesh.vertices[i].position;
      const auto [found, is_new] = known.try_emplace(hash_position(position) ^ facing);
      if (is_new) found->second = photons.density(position, normal);
      result.push_back(found->second);
    }
  }
  return result;
}

}  // namespace

DisplayMesh subdivided(const DisplayMesh& mesh, size_t triangles) {
  double area = 0;
  for (size_t i = 0; i < mesh.vertices.size(); i += 3) area += area_of(&mesh.vertices[i]);
  DisplayMesh fine;
  for (size_t i = 0; i < mesh.vertices.size(); i += 3) {
    const double parts = area_of(&mesh.vertices[i]) / area * static_cast<double>(triangles);
    const int n = std::clamp(static_cast<int>(std::lround(std::sqrt(parts))), 1, kMostParts);
    divide(&mesh.vertices[i], n, fine.vertices);
  }
  return fine;
}

DensityMap make_density_map(const DisplayMesh& surfaces, const PhotonSearch& photons) {
  DensityMap map{surfaces};
  const std::vector<float> values = densities(surfaces, photons);
  const bool none = std::ranges::all_of(values, [](float value) { return value == 0; });
  if (!none) std::tie(map.low, map.high) = value_range(values);
  for (size_t i = 0; i < values.size(); ++i) {
    Vertex& vertex = map.mesh.vertices[i];
    const bool is_clear = vertex.color >> IM_COL32_A_SHIFT == 0;
    const float share = values[i] > map.low && !none
                            ? std::log(values[i] / map.low) / std::log(map.high / map.low)
                            : 0;
    vertex.color =
        to_imgui_color(color_map(kDensityColors, std::min(share, 1.0f)), is_clear ? 0 : 0.5f);
  }
  return map;
}

}  // namespace guidelight

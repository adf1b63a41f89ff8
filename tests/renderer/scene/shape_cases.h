#pragma once

#include <glm/gtc/matrix_transform.hpp>

#include "renderer/scene/shape.h"

/// Shapes for tests.
namespace guidelight::shape_test {

inline ShapeDescription describe(decltype(ShapeDescription::geometry) geometry,
                                 const Mat4& to_world = Mat4(1), bool flip_normals = false) {
  ShapeDescription description;
  description.name = "test";
  description.geometry = std::move(geometry);
  description.to_world = to_world;
  description.flip_normals = flip_normals;
  return description;
}

/// [-1,1]² in z = 0, normal +z, u along x and v along y.
inline MeshShape square() {
  auto mesh = std::make_shared<Mesh>();
  mesh->positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  mesh->uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  mesh->triangles = {{0, 1, 2}, {0, 2, 3}};
  return {mesh};
}

/// [-1,1]³, normals outwards.
inline MeshShape cube() {
  auto mesh = std::make_shared<Mesh>();
  for (int i = 0; i < 8; ++i) {
    mesh->positions.push_back({i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1});
  }
  mesh->triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                     {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return {mesh};
}

/// Turned by no special angle, stretched by `axes`, then moved.
inline Mat4 placed(Vec3 position, Vec3 axes) {
  const Mat4 turn = glm::rotate(Mat4(1), 0.8f, glm::normalize(Vec3(1, -2, 0.7f)));
  const Mat4 inner = glm::rotate(Mat4(1), -0.5f, glm::normalize(Vec3(-1, 1, 3)));
  return glm::translate(Mat4(1), position) * turn * glm::scale(Mat4(1), axes) * inner;
}

}  // namespace guidelight::shape_test

#pragma once

#include <cstdint>
#include <vector>

#include "renderer/scene/description.h"

namespace guidelight {

/// The scene as triangles to look at: analytic shapes are tessellated, materials are one colour.
struct DisplayMesh {
  struct Vertex {
    Vec3 position;    // in world space
    uint32_t normal;  // x, y, z as signed bytes
    uint32_t color;   // red, green, blue for the screen; alpha 255: a light, 0: clear
  };
  std::vector<Vertex> vertices;  // three per triangle
  size_t boxes = 0;              // instances that are only shown as these
};

/// Instances whose triangles would be too many are shown as boxes, those of the heaviest groups
/// first.
DisplayMesh make_display_mesh(const SceneDescription& scene, size_t most_triangles = 10'000'000);

/// What a material looks like from afar, display-referred, and whether it is clear (glass).
struct DisplayMaterial {
  Color color{0.5f};
  bool clear = false;
};
DisplayMaterial display_material(const SceneDescription& scene, int bsdf);

}  // namespace guidelight

#pragma once

#include <cstdint>
#include <vector>

#include "ui/gl/gl_program.h"
#include "ui/gl/vertex_buffer.h"

namespace guidelight {

/// Draws points of the world as discs of one size. Needs the window's context while it lives.
class PointRaster {
 public:
  struct Vertex {
    Vec3 position;
    uint32_t color;  // red, green, blue, alpha
  };

  /// Throws Error if the driver refuses the shaders.
  PointRaster();

  void upload(const std::vector<Vertex>& points);
  bool empty() const { return points_.empty(); }

  /// Into the current target, whose depth hides points: hidden ones get this opacity.
  struct Look {
    float size = 3;  // diameter [pixels]
    float hidden_opacity = 0.15f;
    Vec4 clip_plane{0, 0, 0, 1};
  };
  void draw(const Mat4& clip_from_world, const Look& look) const;

 private:
  GlProgram program_;
  VertexBuffer points_;
};

}  // namespace guidelight

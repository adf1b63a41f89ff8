#pragma once

#include "ui/gl/gl_program.h"
#include "ui/gl/vertex_buffer.h"
#include "ui/scout/display_mesh.h"

namespace guidelight {

/// DepthOnly draws nothing that can be seen; Map lays the colours of a map over surfaces that have
/// been drawn.
enum class MeshStyle { Shaded, Wireframe, SeeThrough, DepthOnly, Map };

/// Draws the triangles of a scene. Needs the window's context while it lives.
class MeshRaster {
 public:
  /// Throws Error if the driver refuses the shaders.
  MeshRaster();

  void upload(const DisplayMesh& mesh);
  bool empty() const { return vertices_.empty(); }

  struct Look {
    MeshStyle style = MeshStyle::Shaded;
    Vec3 eye{0};  // lit from here
    /// Points with dot(plane, (p, 1)) < 0 are cut away.
    Vec4 clip_plane{0, 0, 0, 1};
    float opacity = 1;  // of maps
  };
  /// Into the current target.
  void draw(const Mat4& clip_from_world, const Look& look) const;

 private:
  GlProgram program_;
  VertexBuffer vertices_;
};

}  // namespace guidelight

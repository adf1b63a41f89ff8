#include "ui/gl/mesh_raster.h"

#include <epoxy/gl.h>

#include <cstddef>

namespace guidelight {
namespace {

// Vertices are not shared, so a vertex knows by its number which corner of its triangle it is.
constexpr const char* kMeshVertexShader = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 normal;
layout(location = 2) in vec4 color;
uniform mat4 clip_from_world;
uniform vec4 clip_plane;
uniform vec3 eye;
out vec3 to_eye;
out vec3 surface_normal;
out vec4 surface_color;
out vec3 corner;
void main() {
  gl_Position = clip_from_world * vec4(position, 1);
  gl_ClipDistance[0] = dot(clip_plane, vec4(position, 1));
  to_eye = eye - position;
  surface_normal = normal.xyz;
  surface_color = color;
  corner = vec3(0);
  corner[gl_VertexID % 3] = 1;
}
)";

constexpr const char* kMeshFragmentShader = R"(#version 330 core
in vec3 to_eye;
in vec3 surface_normal;
in vec4 surface_color;
in vec3 corner;
uniform int style;
uniform float opacity;
out vec4 color;
void main() {
  float facing = abs(dot(normalize(to_eye), normalize(surface_normal)));
  bool is_light = surface_color.a > 0.9;
  bool is_clear = surface_color.a < 0.1;
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  if (is_clear && style != 2 && ((pixel.x + pixel.y) & 1) == 0) discard;
  vec3 shaded = is_light ? surface_color.rgb : surface_color.rgb * (0.22 + 0.78 * facing);
  if (style == 1) {
    vec3 width = fwidth(corner);
    vec3 inside = smoothstep(vec3(0), 1.2 * width, corner);
    float edge = 1 - min(min(inside.x, inside.y), inside.z);
    if (edge < 0.05) discard;
    color = vec4(mix(vec3(0.11), shaded, 0.25 + 0.6 * edge), 1);
  } else if (style == 2) {
    float rim = (1 - facing) * (1 - facing);
    color = vec4(shaded, is_light ? 0.8 : 0.07 + 0.4 * rim);
  } else if (style == 4) {
    if (is_clear) discard;
    color = vec4(surface_color.rgb * (0.8 + 0.2 * facing), opacity);
  } else {
    color = vec4(shaded, 1);
  }
}
)";

}  // namespace

MeshRaster::MeshRaster()
    : program_(kMeshVertexShader, kMeshFragmentShader),
      vertices_(
          sizeof(DisplayMesh::Vertex),
          {{VertexBuffer::Attribute::Kind::Float, 3, offsetof(DisplayMesh::Vertex, position)},
           {VertexBuffer::Attribute::Kind::SignedBytes, 4, offsetof(DisplayMesh::Vertex, normal)},
           {VertexBuffer::Attribute::Kind::UnsignedBytes, 4,
            offsetof(DisplayMesh::Vertex, color)}}) {}

void MeshRaster::upload(const DisplayMesh& mesh) {
  vertices_.upload<DisplayMesh::Vertex>(mesh.vertices);
}

void MeshRaster::draw(const Mat4& clip_from_world, const Look& look) const {
  if (empty()) return;
  program_.use();
  program_.set("clip_from_world", clip_from_world);
  program_.set("clip_plane", look.clip_plane);
  program_.set("eye", look.eye);
  program_.set("style", static_cast<int>(look.style));
  program_.set("opacity", look.opacity);
  const bool transparent = look.style == MeshStyle::SeeThrough;
  const bool map = look.style == MeshStyle::Map;
  if (transparent) {
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glDisable(GL_DEPTH_TEST);
  } else if (map) {
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glEnable(GL_POLYGON_OFFSET_FILL);  // before the same surface, divided otherwise
    glPolygonOffset(-1, -4);
  } else {
    glDisable(GL_BLEND);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
  }
  if (look.style == MeshStyle::DepthOnly) glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  glEnable(GL_CLIP_DISTANCE0);
  vertices_.draw_triangles();
  glDisable(GL_CLIP_DISTANCE0);
  glDisable(GL_POLYGON_OFFSET_FILL);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

}  // namespace guidelight

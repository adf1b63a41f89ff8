#include "ui/gl/point_raster.h"

#include <epoxy/gl.h>

#include <cstddef>

namespace guidelight {
namespace {

// Photons lie on surfaces; a little nearer, these do not hide them.
constexpr const char* kPointVertexShader = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 color;
uniform mat4 clip_from_world;
uniform vec4 clip_plane;
uniform float size;
uniform float opacity;
out vec4 point_color;
void main() {
  gl_Position = clip_from_world * vec4(position, 1);
  gl_Position.z -= 2e-4 * gl_Position.w;
  gl_PointSize = size;
  point_color = vec4(color.rgb, color.a * opacity);
  if (dot(clip_plane, vec4(position, 1)) < 0) gl_Position = vec4(2, 2, 2, 1);
}
)";

constexpr const char* kPointFragmentShader = R"(#version 330 core
in vec4 point_color;
uniform float size;
out vec4 color;
void main() {
  if (size > 2.5 && length(gl_PointCoord - 0.5) > 0.5) discard;
  color = point_color;
}
)";

}  // namespace

PointRaster::PointRaster()
    : program_(kPointVertexShader, kPointFragmentShader),
      points_(sizeof(Vertex),
              {{VertexBuffer::Attribute::Kind::Float, 3, offsetof(Vertex, position)},
               {VertexBuffer::Attribute::Kind::UnsignedBytes, 4, offsetof(Vertex, color)}}) {}

void PointRaster::upload(const std::vector<Vertex>& points) { points_.upload<Vertex>(points); }

void PointRaster::draw(const Mat4& clip_from_world, const Look& look) const {
  if (empty()) return;
  program_.use();
  program_.set("clip_from_world", clip_from_world);
  program_.set("clip_plane", look.clip_plane);
  program_.set("size", look.size);
  glEnable(GL_PROGRAM_POINT_SIZE);
  glEnable(GL_DEPTH_TEST);
  glDepthMask(GL_FALSE);
  glEnable(GL_BLEND);
  // Colour stays as it is over a clear background, opacity adds up.
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glDepthFunc(GL_GREATER);
  program_.set("opacity", look.hidden_opacity);
  points_.draw_points();
  glDepthFunc(GL_LEQUAL);
  program_.set("opacity", 1.0f);
  points_.draw_points();
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
  glDisable(GL_PROGRAM_POINT_SIZE);
}

}  // namespace guidelight

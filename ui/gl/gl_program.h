#pragma once

#include <string>

#include "renderer/math/vector.h"

namespace guidelight {

/// A linked OpenGL program of a vertex and a fragment shader. Needs the window's context while it
/// lives.
class GlProgram {
 public:
  /// Throws Error with the driver's words if a shader is not accepted.
  GlProgram(const char* vertex_source, const char* fragment_source);
  ~GlProgram();
  GlProgram(const GlProgram&) = delete;
  GlProgram& operator=(const GlProgram&) = delete;

  void use() const;
  // Of the program in use.
  void set(const char* uniform, const Mat4& value) const;
  void set(const char* uniform, Vec4 value) const;
  void set(const char* uniform, Vec3 value) const;
  void set(const char* uniform, float value) const;
  void set(const char* uniform, int value) const;

 private:
  int location(const char* uniform) const;

  unsigned name_ = 0;
};

}  // namespace guidelight

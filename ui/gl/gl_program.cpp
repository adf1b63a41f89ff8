#include "ui/gl/gl_program.h"

#include <epoxy/gl.h>

#include <array>
#include <glm/gtc/type_ptr.hpp>

#include "renderer/error.h"

namespace guidelight {
namespace {

GLuint compile_shader(GLenum kind, const char* source) {
  const GLuint shader = glCreateShader(kind);
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  GLint accepted = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &accepted);
  if (accepted) return shader;
  std::array<char, 1024> text{};
  glGetShaderInfoLog(shader, text.size(), nullptr, text.data());
  glDeleteShader(shader);
  throw Error("the graphics driver refuses a shader ({}): update the driver", text.data());
}

}  // namespace

GlProgram::GlProgram(const char* vertex_source, const char* fragment_source) {
  const GLuint vertex = compile_shader(GL_VERTEX_SHADER, vertex_source);
  const GLuint fragment = compile_shader(GL_FRAGMENT_SHADER, fragment_source);
  name_ = glCreateProgram();
  glAttachShader(name_, vertex);
  glAttachShader(name_, fragment);
  glLinkProgram(name_);
  glDeleteShader(vertex);
  glDeleteShader(fragment);
}

GlProgram::~GlProgram() { glDeleteProgram(name_); }

void GlProgram::use() const { glUseProgram(name_); }

int GlProgram::location(const char* uniform) const { return glGetUniformLocation(name_, uniform); }

void GlProgram::set(const char* uniform, const Mat4& value) const {
  glUniformMatrix4fv(location(uniform), 1, GL_FALSE, glm::value_ptr(value));
}
void GlProgram::set(const char* uniform, Vec4 value) const {
  glUniform4fv(location(uniform), 1, glm::value_ptr(value));
}
void GlProgram::set(const char* uniform, Vec3 value) const {
  glUniform3fv(location(uniform), 1, glm::value_ptr(value));
}
void GlProgram::set(const char* uniform, float value) const {
  glUniform1f(location(uniform), value);
}
void GlProgram::set(const char* uniform, int value) const { glUniform1i(location(uniform), value); }

}  // namespace guidelight

#include "ui/gl/vertex_buffer.h"

#include <epoxy/gl.h>

namespace guidelight {
namespace {

GLenum type_of(VertexBuffer::Attribute::Kind kind) {
  using Kind = VertexBuffer::Attribute::Kind;
  return kind == Kind::Float ? GL_FLOAT : kind == Kind::SignedBytes ? GL_BYTE : GL_UNSIGNED_BYTE;
}

}  // namespace

VertexBuffer::VertexBuffer(size_t vertex_size, std::initializer_list<Attribute> attributes)
    : vertex_size_(vertex_size) {
  glGenVertexArrays(1, &array_);
  glGenBuffers(1, &buffer_);
  glBindVertexArray(array_);
  glBindBuffer(GL_ARRAY_BUFFER, buffer_);
  GLuint index = 0;
  for (const Attribute& attribute : attributes) {
    glEnableVertexAttribArray(index);
    glVertexAttribPointer(index++, attribute.components, type_of(attribute.kind), GL_TRUE,
                          static_cast<GLsizei>(vertex_size),
                          reinterpret_cast<const void*>(attribute.offset));
  }
  glBindVertexArray(0);
}

VertexBuffer::~VertexBuffer() {
  glDeleteBuffers(1, &buffer_);
  glDeleteVertexArrays(1, &array_);
}

void VertexBuffer::upload(const void* vertices, size_t count) {
  count_ = static_cast<int>(count);
  glBindBuffer(GL_ARRAY_BUFFER, buffer_);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(count * vertex_size_), vertices,
               GL_DYNAMIC_DRAW);
}

void VertexBuffer::draw(unsigned mode) const {
  glBindVertexArray(array_);
  glDrawArrays(mode, 0, count_);
  glBindVertexArray(0);
}

void VertexBuffer::draw_triangles() const { draw(GL_TRIANGLES); }
void VertexBuffer::draw_points() const { draw(GL_POINTS); }

}  // namespace guidelight

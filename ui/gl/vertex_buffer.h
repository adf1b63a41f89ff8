#pragma once

#include <cstddef>
#include <initializer_list>
#include <span>

namespace guidelight {

/// Vertices in the memory of the graphics card. Needs the window's context while it lives.
class VertexBuffer {
 public:
  /// A member of the vertex, as input of the shader with the same position in the list.
  struct Attribute {
    enum class Kind { Float, SignedBytes, UnsignedBytes };  // bytes are scaled to -1 … 1 and 0 … 1
    Kind kind;
    int components;
    size_t offset;  // [bytes]
  };

  VertexBuffer(size_t vertex_size, std::initializer_list<Attribute> attributes);
  ~VertexBuffer();
  VertexBuffer(const VertexBuffer&) = delete;
  VertexBuffer& operator=(const VertexBuffer&) = delete;

  template <class Vertex>
  void upload(std::span<const Vertex> vertices) {
    upload(vertices.data(), vertices.size());
  }
  bool empty() const { return count_ == 0; }

  // With the program in use:
  void draw_triangles() const;
  void draw_points() const;

 private:
  void upload(const void* vertices, size_t count);
  void draw(unsigned mode) const;

  size_t vertex_size_;
  unsigned array_ = 0;
  unsigned buffer_ = 0;
  int count_ = 0;
};

}  // namespace guidelight

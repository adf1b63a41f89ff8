#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "renderer/sampling/distribution.h"
#include "renderer/scene/shape.h"

namespace guidelight {

/// Triangles in world space. The index list, uvs and colours stay shared with the description's
/// mesh. The outside of a triangle is where its vertex normals point to, without them where its
/// vertices run counter-clockwise.
class TriangleMesh final : public Shape {
 public:
  /// Throws Error for positions, uvs or colours that are not finite, indices out of range,
  /// attribute lists of another length than the positions, a mesh without triangles or a singular
  /// transform.
  TriangleMesh(const ShapeDescription& description, const Mat4& to_world);

  /// World-space vertices. The storage goes on for at least 16 bytes after the last one, as
  /// Embree's vertex buffers require.
  std::span<const Vec3> positions() const {
    return {positions_.data(), positions_.size() - kPadding};
  }
  std::span<const std::array<uint32_t, 3>> triangles() const { return mesh_->triangles; }

  void fill(const Ray& ray, const Hit& hit, SurfacePoint& point) const override;
  float sample_area(Vec2 u, SurfacePoint& point) const override;
  float pdf_area(const SurfacePoint&) const override { return inverse_area_; }
  Vec3 normal_derivative(const Hit& hit, Vec3 position, Vec3 displacement) const override;
  float area() const override { return area_; }
  Bounds bounds() const override { return bounds_; }
  size_t triangle_count() const override { return mesh_->triangles.size(); }
  size_t bytes() const override;

 private:
  static constexpr size_t kPadding = 2;

  void measure();
  bool is_flat() const;
  void fill_triangle(uint32_t triangle, Vec2 barycentric, SurfacePoint& point) const;

  /// What every hit of a triangle needs.
  struct Face {
    Vec3 normal;   // unit, outside
    float offset;  // SurfacePoint::offset
  };
  Face measure_face(const std::array<uint32_t, 3>& triangle) const;
  void parametrise(const std::array<uint32_t, 3>& triangle, Vec2 barycentric, Vec3 shading_normal,
                   SurfacePoint& point) const;

  std::shared_ptr<const Mesh> mesh_;
  std::vector<Face> faces_;
  std::vector<Vec3> positions_;  // and kPadding unused entries
  std::vector<Vec3> normals_;    // world space; zero where the file's normal is unusable
  float orientation_ = 1;        // -1 if the winding in world space runs the other way round
  Bounds bounds_;
  DiscreteDistribution triangle_distribution_;  // by area
  float area_ = 0;
  float inverse_area_ = 0;
};

}  // namespace guidelight

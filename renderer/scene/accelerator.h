#pragma once

#include <memory>
#include <span>

#include "renderer/scene/shape.h"

namespace guidelight {

/// Ray queries over shapes and instances of groups of shapes. The only user of Embree. Built once,
/// then immutable; it keeps references to the shapes it was given.
class Accelerator {
 public:
  /// Shape ids are below `shape_count`.
  explicit Accelerator(uint32_t shape_count);
  ~Accelerator();
  Accelerator(const Accelerator&) = delete;
  Accelerator& operator=(const Accelerator&) = delete;

  /// `id` is what Hit::shape will say. Shapes with group kNone stand in the scene itself, others
  /// are seen only through instances of their group.
  void add_shape(const Shape& shape, uint32_t id, int group = kNone);
  /// `id` is what Hit::instance will say.
  void add_instance(int group, const Mat4& to_world, uint32_t id);
  /// Builds the hierarchies; queries are allowed from then on. Throws Error if memory runs out.
  void build();

  /// Rays that are not finite, or beyond kLargestRay, meet nothing.
  Hit intersect(const Ray& ray) const;
  bool occluded(const Ray& ray) const;
  /// Batches, traced in packets.
  void intersect(std::span<const Ray> rays, std::span<Hit> hits) const;
  void occluded(std::span<const Ray> rays, std::span<uint8_t> blocked) const;

  /// Memory that Embree holds for this scene [bytes].
  size_t bytes() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace guidelight

#include "renderer/scene/accelerator.h"

#include <gtest/gtest.h>

#include "renderer/scene/analytic_shape.h"
#include "renderer/scene/triangle_mesh.h"

namespace guidelight {
namespace {

/// A ball or a triangle at the origin.
class OneShape {
 public:
  explicit OneShape(decltype(ShapeDescription::geometry) geometry) {
    ShapeDescription description;
    description.geometry = std::move(geometry);
    shape_ = make_shape(description);
    accelerator_.add_shape(*shape_, 0);
    accelerator_.build();
  }
  const Accelerator& operator*() const { return accelerator_; }

 private:
  std::unique_ptr<Shape> shape_;
  Accelerator accelerator_{1};
};

MeshShape triangle() {
  Mesh mesh;
  mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  return {std::make_shared<const Mesh>(mesh)};
}

/// Embree would end the process for these.
TEST(Accelerator, RaysThatAreNoneMeetNothing) {
  const Vec3 ahead(0, 0, 1);
  const Vec3 start(0, 0, -5);
  const std::vector<Ray> invalid = {
      {Vec3(NAN, 0, -5), ahead},   {start, Vec3(0, NAN, 1)},   {Vec3(0, 0, -kInfinity), ahead},
      {Vec3(0, 0, -1e19f), ahead}, {start, Vec3(0, 0, 1e19f)}, {start, Vec3(0, 0, kInfinity)},
      {Vec3(1e30f, 0, -5), ahead}, {start, ahead, NAN},
  };
  for (const OneShape& scene : {OneShape(SphereShape{}), OneShape(triangle())}) {
    for (const Ray& ray : invalid) {
      EXPECT_FALSE((*scene).intersect(ray).valid());
      EXPECT_FALSE((*scene).occluded(ray));
    }
    // Among valid ones in a packet, whose results they must not change.
    std::vector<Ray> rays;
    for (const Ray& ray : invalid) rays.insert(rays.end(), {ray, {start, ahead}});
    std::vector<Hit> hits(rays.size());
    std::vector<uint8_t> blocked(rays.size());
    (*scene).intersect(rays, hits);
    (*scene).occluded(rays, blocked);
    for (size_t i = 0; i < rays.size(); ++i) {
      EXPECT_EQ(hits[i].valid(), i % 2 == 1) << i;
      EXPECT_EQ(blocked[i], i % 2) << i;
    }
  }
}

}  // namespace
}  // namespace guidelight

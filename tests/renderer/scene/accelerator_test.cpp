#include "renderer/scene/accelerator.h"

#include <gtest/gtest.h>

#include "renderer/sampling/random.h"
#include "renderer/sampling/warp.h"
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

/// Rays towards the origin's neighbourhood from all around, or all from one place; some end early.
std::vector<Ray> rays_to_origin(bool from_one_place) {
  Rng rng(1, 2, from_one_place ? 3 : 4);
  std::vector<Ray> rays;
  for (int i = 0; i < 4096; ++i) {
    const Vec3 start = from_one_place ? Vec3(8, 16, -40) : 3.0f * square_to_sphere(rng.next_vec2());
    const Vec3 target = 1.5f * square_to_sphere(rng.next_vec2()) * rng.next_float();
    const float distance = glm::length(target - start);
    const float t_max = rng.next_float() < 0.5f ? kInfinity : 2 * distance * rng.next_float();
    rays.push_back({start, (target - start) / distance, t_max});
  }
  return rays;
}

/// Packets take other ways through the shapes' equations and through the hierarchy than single rays
/// do, and those whose rays go one way take yet another. Only rays that graze an edge may disagree.
TEST(Accelerator, PacketsMeetWhatSingleRaysMeet) {
  for (const OneShape& scene : {OneShape(SphereShape{}), OneShape(DiskShape{}),
                                OneShape(CylinderShape{}), OneShape(triangle())}) {
    for (const bool from_one_place : {false, true}) {
      const std::vector<Ray> rays = rays_to_origin(from_one_place);
      std::vector<Hit> hits(rays.size());
      std::vector<uint8_t> blocked(rays.size());
      (*scene).intersect(rays, hits);
      (*scene).occluded(rays, blocked);
      int met = 0, differ = 0;
      for (size_t i = 0; i < rays.size(); ++i) {
        const Hit single = (*scene).intersect(rays[i]);
        met += single.valid();
        differ += hits[i].valid() != single.valid() || (blocked[i] != 0) != single.valid();
        if (hits[i].valid() && single.valid()) {
          EXPECT_NEAR(hits[i].t, single.t, 1e-4f) << i;
        }
      }
      EXPECT_GT(met, 400);
      EXPECT_LE(differ, 2);
    }
  }
}

}  // namespace
}  // namespace guidelight

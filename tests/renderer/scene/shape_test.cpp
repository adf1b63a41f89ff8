#include "renderer/scene/shape.h"

#include <gtest/gtest.h>

#include "renderer/error.h"
#include "renderer/sampling/random.h"
#include "renderer/sampling/warp.h"
#include "renderer/scene/accelerator.h"
#include "renderer/scene/analytic_shape.h"
#include "renderer/scene/medium.h"
#include "renderer/scene/triangle_mesh.h"
#include "tests/renderer/scene/shape_cases.h"
#include "tests/statistics/hypothesis_tests.h"

namespace guidelight {
namespace {

using namespace shape_test;

/// A shape that can be traced.
struct Traced {
  explicit Traced(const ShapeDescription& description) : shape(make_shape(description)) {
    accelerator.add_shape(*shape, 0);
    accelerator.build();
  }
  /// Hit::valid() is false for a miss.
  Hit intersect(const Ray& ray, SurfacePoint& point) const {
    const Hit hit = accelerator.intersect(ray);
    if (hit.valid()) shape->fill(ray, hit, point);
    return hit;
  }

  std::unique_ptr<Shape> shape;
  Accelerator accelerator{1};
};

struct ShapeCase {
  const char* name;
  decltype(ShapeDescription::geometry) geometry;
};

const std::vector<ShapeCase> kShapeCases = {{"sphere", SphereShape{}},
                                            {"disk", DiskShape{}},
                                            {"cylinder", CylinderShape{}},
                                            {"square", square()},
                                            {"cube", cube()}};

class EveryShape : public ::testing::TestWithParam<ShapeCase> {};

const Vec3 kAxes[] = {Vec3(1), Vec3(3, 1, 0.4f), Vec3(-1, 2, 0.7f)};
const double kShapeLevel = statistics::sidak_level(1e-3, 3 * kShapeCases.size() * std::size(kAxes));

/// Crofton: random lines through a sphere of radius R around a surface of area A meet it A/(2πR²)
/// times on average.
TEST_P(EveryShape, AreaIsWhatRandomLinesMeasure) {
  for (const Vec3 axes : kAxes) {
    const Traced traced(describe(GetParam().geometry, placed({1, 2, 3}, axes)));
    const Bounds bounds = traced.shape->bounds();
    const float radius = 1.01f * bounds.radius();
    statistics::Moments crossings;
    Rng rng(1, 0, 0);
    for (int i = 0; i < 60000; ++i) {
      const Frame frame = Frame::from_normal(square_to_sphere(rng.next_vec2()));
      const Vec2 disk = radius * square_to_disk(rng.next_vec2());
      Ray ray{bounds.center() + frame.to_world(Vec3(disk, radius)), -frame.n, kInfinity};
      int count = 0;
      SurfacePoint point;
      while (traced.intersect(ray, point).valid() && count < 10) {
        ++count;
        ray = point.spawn_ray(ray.direction);
      }
      crossings.add(count);
    }
    const double scale = 2 * kPi * sqr(double(radius));
    EXPECT_GT(statistics::t_test(crossings, traced.shape->area() / scale, 1e-5), kShapeLevel)
        << crossings.mean() * scale << " for " << traced.shape->area();
  }
}

TEST_P(EveryShape, SamplesLieOnTheSurfaceWithTheirDensity) {
  for (const Vec3 axes : kAxes) {
    const auto shape = make_shape(describe(GetParam().geometry, placed({1, 2, 3}, axes)));
    const Bounds bounds = shape->bounds();
    statistics::Moments area;
    Rng rng(2, 0, 0);
    for (int i = 0; i < 50000; ++i) {
      SurfacePoint p;
      const float pdf = shape->sample_area(rng.next_vec2(), p);
      ASSERT_NEAR(glm::length(p.geometric_normal), 1, 1e-5f);
      ASSERT_NEAR(shape->pdf_area(p) / pdf, 1, 1e-3f);
      ASSERT_TRUE(glm::all(glm::lessThanEqual(bounds.lower - 1e-5f, p.position)));
      ASSERT_TRUE(glm::all(glm::lessThanEqual(p.position, bounds.upper + 1e-5f)));
      area.add(1 / pdf);
    }
    EXPECT_GT(statistics::t_test(area, shape->area(), 2e-5 * shape->area()), kShapeLevel)
        << area.mean();
  }
}

/// Points that rays hit, with u and v moved a little: the derivatives must lead to the neighbours.
TEST_P(EveryShape, DerivativesFollowTheTextureCoordinates) {
  const Traced traced(describe(GetParam().geometry, placed({1, 2, 3}, {3, 1, 0.4f})));
  Rng rng(3, 0, 0);
  int tested = 0;
  for (int i = 0; i < 2000; ++i) {
    SurfacePoint a;
    traced.shape->sample_area(rng.next_vec2(), a);
    if (a.dpdu == Vec3(0)) continue;  // a mesh without texture coordinates
    EXPECT_NEAR(glm::dot(glm::normalize(a.dpdu), a.geometric_normal), 0, 1e-4f);
    EXPECT_NEAR(glm::dot(glm::normalize(a.dpdv), a.geometric_normal), 0, 1e-4f);
    const Vec2 step = 0.002f * (rng.next_vec2() - 0.5f);
    const Vec3 moved = a.position + step.x * a.dpdu + step.y * a.dpdv;
    SurfacePoint b;
    const Ray ray{moved + 0.1f * a.geometric_normal, -a.geometric_normal, 0.2f};
    if (!traced.intersect(ray, b).valid()) continue;                     // over the edge
    if (max_component(Vec3(glm::abs(b.uv - a.uv), 0)) > 0.5f) continue;  // over the seam
    EXPECT_NEAR(b.uv.x - a.uv.x, step.x, 1e-4f + 0.05f * std::abs(step.x));
    EXPECT_NEAR(b.uv.y - a.uv.y, step.y, 1e-4f + 0.05f * std::abs(step.y));
    ++tested;
  }
  EXPECT_TRUE(tested > 1000 || std::string(GetParam().name) == "cube");
}

/// Rays that leave a surface do not meet it again where they start, whatever the scale and the
/// distance from the origin. Outwards these convex shapes are never met again; inwards only at the
/// other side.
TEST_P(EveryShape, RaysDoNotMeetTheSurfaceTheyLeave) {
  const bool flat =
      GetParam().name == std::string("square") || GetParam().name == std::string("disk");
  const bool mesh = std::holds_alternative<MeshShape>(GetParam().geometry);
  Rng rng(4, 0, 0);
  for (const float scale : {1e-3f, 0.02f, 1.0f, 30.0f, 1e3f, 1e5f}) {
    for (const float distance : {0.0f, 1.0f, 100.0f, 1e4f}) {
      for (const Vec3 axes : {Vec3(1), Vec3(4, 1, 0.3f)}) {
        const Vec3 center = scale * distance * Vec3(0.3f, -0.8f, 0.5f);
        const Traced traced(describe(GetParam().geometry, placed(center, scale * axes)));
        const auto* analytic = dynamic_cast<const AnalyticShape*>(traced.shape.get());
        int failures = 0;
        for (int i = 0; i < 4200; ++i) {
          SurfacePoint p;
          traced.shape->sample_area(rng.next_vec2(), p);
          Vec3 direction = square_to_sphere(rng.next_vec2());
          if (!flat && glm::dot(direction, p.geometric_normal) < 0) direction = -direction;
          const Ray ray = p.spawn_ray(direction);
          float t;
          failures +=
              analytic ? analytic->intersect(ray, 0, t) : traced.accelerator.intersect(ray).valid();
        }
        EXPECT_EQ(failures, 0) << "scale " << scale << ", distance " << distance << ", mesh "
                               << mesh;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, EveryShape, ::testing::ValuesIn(kShapeCases),
                         [](const auto& test) { return test.param.name; });

TEST(Shape, RaysInsideASphereMeetTheOtherSide) {
  Rng rng(5, 0, 0);
  for (const float scale : {1e-3f, 1.0f, 1e5f}) {
    for (const float distance : {0.0f, 100.0f}) {
      const Vec3 center = scale * distance * Vec3(0.3f, -0.8f, 0.5f);
      const Traced traced(describe(SphereShape{}, placed(center, Vec3(scale))));
      for (int i = 0; i < 20000; ++i) {
        SurfacePoint p;
        traced.shape->sample_area(rng.next_vec2(), p);
        const Frame frame = Frame::from_normal(-p.geometric_normal);
        const Vec3 direction = frame.to_world(square_to_cosine_hemisphere(rng.next_vec2()));
        const float chord = 2 * scale * glm::dot(direction, frame.n);
        if (chord < 100 * p.offset) continue;
        const Hit hit = traced.accelerator.intersect(p.spawn_ray(direction));
        ASSERT_TRUE(hit.valid());
        ASSERT_NEAR(hit.t, chord, 1e-3f * chord + 4 * p.offset * scale / chord + 4 * p.offset);
      }
    }
  }
}

TEST(Shape, OutsideSurvivesMirroring) {
  for (const float sign : {1.0f, -1.0f}) {
    for (const bool flip : {false, true}) {
      const Mat4 to_world = placed({5, 6, 7}, {2 * sign, 1, 0.5f});
      const Vec3 center(to_world[3]);
      for (const auto& geometry : {decltype(ShapeDescription::geometry)(SphereShape{}),
                                   decltype(ShapeDescription::geometry)(cube())}) {
        const auto shape = make_shape(describe(geometry, to_world, flip));
        Rng rng(6, 0, 0);
        for (int i = 0; i < 200; ++i) {
          SurfacePoint p;
          shape->sample_area(rng.next_vec2(), p);
          const bool outwards = glm::dot(p.geometric_normal, p.position - center) > 0;
          EXPECT_EQ(outwards, !flip);
          EXPECT_GT(glm::dot(p.frame.n, p.geometric_normal), 0.99f);
        }
      }
    }
  }
}

TEST(Shape, SmoothNormalsAreInterpolatedAndMirrored) {
  auto mesh = std::make_shared<Mesh>(*square().mesh);
  const Vec3 slanted = glm::normalize(Vec3(1, 0, 1));
  mesh->normals = {slanted, slanted, slanted, slanted};
  const Mat4 mirror = glm::scale(Mat4(1), Vec3(-1, 1, 1));
  const auto shape = make_shape(describe(MeshShape{mesh}, mirror));
  SurfacePoint p;
  shape->sample_area({0.3f, 0.4f}, p);
  EXPECT_NEAR(glm::length(p.frame.n - Vec3(-slanted.x, 0, slanted.z)), 0, 1e-5f);
  EXPECT_NEAR(p.geometric_normal.z, 1, 1e-6f);
  // A normal of no length falls back on the face's.
  mesh->normals = {{}, {}, {}, {}};
  make_shape(describe(MeshShape{mesh}))->sample_area({0.3f, 0.4f}, p);
  EXPECT_NEAR(p.frame.n.z, 1, 1e-6f);
}

TEST(Shape, VertexNormalsThatOpposeTheWindingSayWhereOutsideIs) {
  auto mesh = std::make_shared<Mesh>(*square().mesh);
  const Vec3 slanted = glm::normalize(Vec3(1, 0, -1));
  mesh->normals = {slanted, slanted, slanted, {0, 0, -1}};
  for (const float mirror : {1.0f, -1.0f}) {
    for (const bool flip : {false, true}) {
      const Mat4 to_world = glm::scale(Mat4(1), Vec3(mirror, 1, 1));
      const Traced traced(describe(MeshShape{mesh}, to_world, flip));
      const float outside = flip ? 1 : -1;
      SurfacePoint sampled, hit;
      traced.shape->sample_area({0.3f, 0.4f}, sampled);
      ASSERT_TRUE(traced.intersect({{0.1f, 0.2f, 3}, {0, 0, -1}, kInfinity}, hit).valid());
      for (const SurfacePoint& p : {sampled, hit}) {
        EXPECT_EQ(p.geometric_normal.z, outside);
        EXPECT_GT(p.frame.n.z * outside, 0.5f);
      }
      // Light and media ask the geometric normal for their side.
      const Medium interior, exterior;
      hit.is_medium_boundary = true;
      hit.interior = &interior;
      hit.exterior = &exterior;
      EXPECT_EQ(medium_beyond(hit, {0, 0, outside}, nullptr), &exterior);
      EXPECT_EQ(medium_beyond(hit, {0, 0, -outside}, nullptr), &interior);
      EXPECT_GT(hit.offset_origin({0, 0, 1}).z, hit.position.z);
    }
  }
}

TEST(Shape, DegenerateTrianglesAreNeverSampled) {
  auto mesh = std::make_shared<Mesh>(*square().mesh);
  mesh->triangles.insert(mesh->triangles.begin(), {{0, 0, 1}, {2, 2, 2}});
  mesh->triangles.push_back({0, 2, 2});
  const auto shape = make_shape(describe(MeshShape{mesh}));
  EXPECT_FLOAT_EQ(shape->area(), 4);
  Rng rng(7, 0, 0);
  for (int i = 0; i < 10000; ++i) {
    SurfacePoint p;
    shape->sample_area(rng.next_vec2(), p);
    ASSERT_TRUE(p.primitive == 2 || p.primitive == 3);
  }
}

TEST(Shape, NearestRootAndHiddenRoots) {
  const auto sphere = make_analytic_shape(describe(SphereShape{}), Mat4(1));
  float t = -1;
  EXPECT_TRUE(sphere->intersect({{0, 0, -3}, {0, 0, 1}, kInfinity}, 0, t));
  EXPECT_FLOAT_EQ(t, 2);
  EXPECT_TRUE(sphere->intersect({{0, 0, -3}, {0, 0, 1}, kInfinity}, 2.5f, t));
  EXPECT_FLOAT_EQ(t, 4);
  EXPECT_FALSE(sphere->intersect({{0, 0, -3}, {0, 0, 1}, 1.9f}, 0, t));
  EXPECT_FLOAT_EQ(t, 4);
  EXPECT_TRUE(sphere->intersect({{0, 0, -3}, {0, 0, 2}, kInfinity}, 0, t));
  EXPECT_FLOAT_EQ(t, 1);
  // Through the open end of a cylinder onto its inner wall.
  const auto cylinder = make_analytic_shape(describe(CylinderShape{}), Mat4(1));
  EXPECT_TRUE(cylinder->intersect({{-1.5f, 0, 1.5f}, {1, 0, -0.4f}, kInfinity}, 0, t));
  EXPECT_NEAR(t, 2.5f, 1e-5f);
  EXPECT_FALSE(cylinder->intersect({{0, 0, -5}, {0, 0, 1}, kInfinity}, 0, t));
}

TEST(Shape, FarSpheresHaveNoFacets) {
  // From 10⁴ radii away, hits projected onto the sphere lie on it to float precision.
  const auto shape = make_analytic_shape(describe(SphereShape{}), Mat4(1));
  Rng rng(8, 0, 0);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 target = square_to_sphere(rng.next_vec2());
    const Vec3 origin = 1e4f * square_to_sphere(rng.next_vec2());
    const Ray ray{origin, glm::normalize(target - origin), kInfinity};
    Hit hit;
    if (!shape->intersect(ray, 0, hit.t)) continue;
    SurfacePoint point;
    shape->fill(ray, hit, point);
    ASSERT_NEAR(glm::length(point.position), 1, 3e-7f);
    ASSERT_NEAR(glm::length(point.geometric_normal - point.position), 0, 1e-6f);
  }
}

TEST(Shape, EmbreeMayReadBeyondTheLastVertex) {
  const TriangleMesh mesh(describe(square()), Mat4(1));
  EXPECT_EQ(mesh.positions().size(), 4u);
  EXPECT_EQ(mesh.triangles().size(), 2u);
  // The bytes exist; the address sanitizer would say if not.
  EXPECT_EQ(mesh.positions().data()[5], Vec3(0));
}

TEST(Shape, BrokenGeometryIsAnError) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const auto broken = [](auto&& change) {
    auto mesh = std::make_shared<Mesh>(*square().mesh);
    change(*mesh);
    return describe(MeshShape{mesh});
  };
  EXPECT_THROW(make_shape(broken([&](Mesh& m) { m.positions[1].y = nan; })), Error);
  EXPECT_THROW(make_shape(broken([&](Mesh& m) { m.positions[1].y = kInfinity; })), Error);
  EXPECT_THROW(make_shape(broken([&](Mesh& m) { m.uvs[0].x = nan; })), Error);
  EXPECT_THROW(make_shape(broken([&](Mesh& m) { m.triangles[1][2] = 4; })), Error);
  EXPECT_THROW(make_shape(broken([&](Mesh& m) { m.normals.resize(3); })), Error);
  EXPECT_THROW(make_shape(broken([&](Mesh& m) { m.triangles.clear(); })), Error);
  EXPECT_THROW(make_shape(describe(MeshShape{})), Error);
  EXPECT_THROW(make_shape(describe(InstanceShape{0})), Error);
  for (const ShapeCase& c : kShapeCases) {
    Mat4 singular(1);
    singular[2] = singular[1];
    EXPECT_THROW(make_shape(describe(c.geometry, singular)), Error);
    EXPECT_THROW(make_shape(describe(c.geometry, glm::scale(Mat4(1), Vec3(1, 0, 1)))), Error);
    EXPECT_THROW(make_shape(describe(c.geometry, Mat4(nan))), Error);
    EXPECT_NO_THROW(make_shape(describe(c.geometry, glm::scale(Mat4(1), Vec3(1e-6f)))));
  }
}

}  // namespace
}  // namespace guidelight

#include "renderer/transport/random_walk.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/renderer/test_scenes.h"

namespace guidelight {
namespace {

/// Visitor that keeps the partials of the first vertex.
struct FirstVertex {
  MisPartials partials;
  void escaped(uint32_t, Subpath&) { FAIL() << "the floor was missed"; }
  bool visit(uint32_t, Subpath&, const PathVertex& vertex, const Scattering&) {
    partials = vertex.partials;
    return false;
  }
  void end_segment() {}
};

constexpr Vec3 kFloor{0, 0, 0};
constexpr float kSum = 3;

/// What a segment that falls straight down from anywhere carries to the floor.
MisPartials partials_of(Vec3 origin, float pdf, float sum = kSum) {
  SceneDescription description = testing::empty_scene(8, 8);
  testing::add_sphere(description, kFloor - Vec3(0, 100, 0), 100,
                      testing::add_diffuse(description, Color(0.5f)));
  const auto scene = testing::build(description);
  Subpath path;
  path.ray = {kFloor + Vec3(0, 1, 0), {0, -1, 0}, kInfinity};
  path.origin = origin;
  path.pdf = pdf;
  path.sums = {sum, sum};
  const MisWeights weights{TechniqueCounts{}};
  FirstVertex first;
  RandomWalk(*scene, TransportMode::Radiance, &weights).run({&path, 1}, first);
  return first.partials;
}

TEST(RandomWalk, segments_of_no_length_have_weights) {
  const MisPartials close = partials_of(kFloor, 0.5f);
  EXPECT_NEAR(close.inverse_pdf, 0, 1e-6f);
  // The lengths of both directions of a segment cancel.
  EXPECT_NEAR(close.connection, kSum / 0.5f, 1e-4f);
  EXPECT_NEAR(close.merging, kSum / 0.5f, 1e-4f);
}

/// Guides send paths where a BSDF would hardly send any. Infinite partials, times the 0 of a
/// technique that is off, would be no number.
TEST(RandomWalk, directions_of_almost_no_density_have_weights) {
  const MisPartials rare = partials_of({0, 1, 0}, 1e-36f, 1e10f);
  EXPECT_TRUE(std::isfinite(rare.inverse_pdf));
  EXPECT_TRUE(std::isfinite(rare.connection));
  EXPECT_TRUE(std::isfinite(rare.merging));
  EXPECT_GT(rare.connection, 1e20f);
}

}  // namespace
}  // namespace guidelight

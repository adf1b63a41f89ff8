// The densities of proposals against the proposals themselves: candidates of a path that fall into
// a small disc around a place, each counted by one over its density, sum to the disc's area.

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "renderer/metropolis/bidirectional_mutation.h"
#include "renderer/metropolis/bidirectional_sampler.h"
#include "renderer/metropolis/caustic_perturbation.h"
#include "renderer/metropolis/eye_perturbations.h"
#include "renderer/metropolis/lens_subpath_mutation.h"
#include "tests/renderer/test_scenes.h"
#include "tests/statistics/hypothesis_tests.h"

namespace guidelight {
namespace {

using statistics::Moments;

constexpr int kMutatedPaths = 4;
constexpr float kMoveRadius = 0.03f;
constexpr PathLengths kTransitionLengths{3, 3};

/// The one vertex by which two paths of the same length differ; -1 if they differ otherwise.
int moved_vertex(const Path& x, const Path& y) {
  const int v = shared_from_light(x, y);
  return v + shared_from_eye(x, y) == x.size() - 1 ? v : -1;
}

/// Whether a disc around a point of the room's walls lies in its wall.
bool lies_within_wall(Vec3 p, float radius = kMoveRadius) {
  int on_wall = 0;
  for (int axis = 0; axis < 3; ++axis) on_wall += std::abs(p[axis]) > 0.999f ? 1 : 0;
  const float limit = 1 - 2 * radius;
  int inside = 0;
  for (int axis = 0; axis < 3; ++axis) inside += std::abs(p[axis]) < limit ? 1 : 0;
  return on_wall == 1 && inside == 2;
}

struct TransitionCase {
  std::string name;
  std::unique_ptr<Mutation> (*make)(const Scene& scene);
  int proposals;
};

class TransitionDensity : public ::testing::TestWithParam<int> {};

const std::vector<TransitionCase>& transition_cases() {
  static const std::vector<TransitionCase> list = {
      {"bidirectional",
       [](const Scene& s) { return make_bidirectional_mutation(s, kTransitionLengths); }, 1000000},
      {"lens", [](const Scene& s) { return make_lens_perturbation(s); }, 100000},
      {"caustic", [](const Scene& s) { return make_caustic_perturbation(s); }, 100000},
      {"lens_subpath",
       [](const Scene& s) { return make_lens_subpath_mutation(s, kTransitionLengths); }, 200000},
      {"photon_map", [](const Scene& s) { return make_photon_map_perturbation(s, kPi / 6); },
       100000},
  };
  return list;
}

TEST_P(TransitionDensity, CountsCandidates) {
  const TransitionCase& test = transition_cases()[GetParam()];
  const auto scene = testing::build(testing::room());
  const auto mutation = test.make(*scene);
  const PathSampler sampler(*scene, kTransitionLengths);
  const double level =
      statistics::sidak_level(statistics::kFalseAlarms, transition_cases().size() * kMutatedPaths);
  Path x, y;
  int tested = 0;
  for (int i = 0; i < 10000 && tested < kMutatedPaths; ++i) {
    Rng rng(3, 0, i);
    if (sampler.sample(x, rng) == 0 || !mutation->is_suitable(x)) continue;
    if (!mutation->propose(x, y, rng)) continue;
    const int v = moved_vertex(x, y);
    if (v <= 0 || v >= x.length() || !lies_within_wall(y.points[v].point.position)) continue;
    const Vec3 center = y.points[v].point.position;
    // Perturbations go neither very near nor far: the whole disc must be within their reach.
    const float distance = glm::distance(center, x.points[v].point.position);
    if (distance < 2 * kMoveRadius || distance > 4 * kMoveRadius) continue;
    Moments area;
    for (int n = 0; n < test.proposals; ++n) {
      const bool counts = mutation->propose(x, y, rng) && moved_vertex(x, y) == v &&
                          glm::distance(y.points[v].point.position, center) < kMoveRadius;
      area.add(counts ? 1 / mutation->density(x, y) : 0);
    }
    ++tested;
    const double expected = kPi * kMoveRadius * kMoveRadius;
    EXPECT_GT(statistics::t_test(area, expected), level)
        << "path " << i << ", vertex " << v << ": " << area.mean() << " +- "
        << area.standard_error() << " against " << expected;
    EXPECT_LT(area.standard_error(), 0.25 * expected) << "path " << i;
  }
  EXPECT_EQ(tested, kMutatedPaths);
}

/// A room of a tenth of the size with a mirror before the camera: densities per area are large.
constexpr float kSmall = 0.1f;
SceneDescription small_room_with_mirror() {
  SceneDescription room = testing::room();
  room.bsdfs.push_back({"mirror", 0, ConductorBsdf{}});
  room.shapes.front().bsdf = static_cast<int>(room.bsdfs.size()) - 1;
  for (ShapeDescription& shape : room.shapes) {
    shape.to_world = glm::scale(Mat4(1), Vec3(kSmall)) * shape.to_world;
  }
  testing::look_at(room, {0, 0, 0.95f * kSmall}, {0, -0.2f * kSmall, -kSmall}, 70);
  return room;
}

// On L D D D S E, keeping the third vertex and drawing it anew are two ways to the same candidates.
TEST(ForcedVertices, AreDrawnWithAProbability) {
  constexpr PathLengths kFive{5, 5};
  constexpr float kWide = 0.2f;  // radius of discs, of half the room
  constexpr int kProposals = 300000;
  const auto scene = testing::build(small_room_with_mirror());
  const auto mutation = make_bidirectional_mutation(*scene, kFive);
  const PathSampler sampler(*scene, kFive);
  Path x, y;
  bool tested = false;
  for (int i = 0; i < 100000 && !tested; ++i) {
    Rng rng(5, 0, i);
    if (sampler.sample(x, rng) == 0 || x.is_finite(4) || !x.is_finite(3)) continue;
    if (!mutation->propose(x, y, rng)) continue;
    const Vec3 center = y.points[2].point.position;
    const bool is_free = lies_within_wall(center / kSmall, kWide) && center.y < 0.9f * kSmall;
    if (moved_vertex(x, y) != 2 || !is_free) continue;
    tested = true;
    Moments area;
    for (int n = 0; n < kProposals; ++n) {
      const bool counts = mutation->propose(x, y, rng) && moved_vertex(x, y) == 2 &&
                          glm::distance(y.points[2].point.position, center) < kWide * kSmall;
      area.add(counts ? 1 / mutation->density(x, y) : 0);
    }
    const double expected = kPi * sqr(kWide * kSmall);
    EXPECT_GT(statistics::t_test(area, expected), statistics::kFalseAlarms)
        << area.mean() << " +- " << area.standard_error() << " against " << expected;
    EXPECT_LT(area.standard_error(), 0.25 * expected);
  }
  EXPECT_TRUE(tested);
}

INSTANTIATE_TEST_SUITE_P(Mutations, TransitionDensity, ::testing::Range(0, 5),
                         [](const auto& test) { return transition_cases()[test.param].name; });

}  // namespace
}  // namespace guidelight

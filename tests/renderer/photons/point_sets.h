#pragma once

#include <string>
#include <vector>

#include "renderer/sampling/random.h"

namespace guidelight::testing {

/// An item of the search structures.
struct TestPoint {
  Vec3 position;
  uint32_t id;
};

struct PointSet {
  std::string name;
  std::vector<TestPoint> points;
};

/// Sets that search structures may stumble over, and ordinary ones.
inline std::vector<PointSet> point_sets() {
  std::vector<PointSet> sets;
  const auto add = [&](std::string name, uint32_t count, auto&& position) {
    PointSet& set = sets.emplace_back(PointSet{std::move(name), {}});
    Rng rng(sets.size(), 0, 0);
    for (uint32_t i = 0; i < count; ++i) set.points.push_back({position(rng, i), i});
  };
  const auto cube = [](Rng& rng, uint32_t) {
    return Vec3(rng.next_float(), rng.next_float(), rng.next_float());
  };
  add("none", 0, cube);
  add("one", 1, cube);
  add("seven", 7, cube);
  add("cube", 20000, cube);
  add("walls of a room far from the origin", 20000, [&](Rng& rng, uint32_t i) {
    Vec3 p = cube(rng, i);
    p[i % 3] = i % 2 ? 1.0f : 0.0f;
    return p + Vec3(1000, -500, 0);
  });
  add("all in one place", 1000, [](Rng&, uint32_t) { return Vec3(0.3f, 0.4f, 0.5f); });
  add("a line", 3000, [](Rng& rng, uint32_t) { return Vec3(0.5f, rng.next_float(), 0.25f); });
  add("two clusters", 4000, [&](Rng& rng, uint32_t i) {
    return (i % 2 ? 1e-6f : 1e-3f) * cube(rng, i) + Vec3(i % 2 ? 1.0f : 0.0f);
  });
  add("a lattice of many equals", 4096,
      [](Rng&, uint32_t i) { return 0.25f * Vec3(i % 4, i / 4 % 4, i / 16 % 4); });
  add("some not finite", 2000, [&](Rng& rng, uint32_t i) {
    Vec3 p = cube(rng, i);
    if (i % 5 == 0) p[i % 3] = std::numeric_limits<float>::quiet_NaN();
    if (i % 7 == 0) p[i % 3] = i % 2 ? kInfinity : -kInfinity;
    return p;
  });
  add("none finite", 100, [](Rng&, uint32_t) { return Vec3(kInfinity); });
  return sets;
}

/// Places from which to search: members of the set, and others in and around it; fewer under
/// sanitizers, where brute force is slow.
inline std::vector<Vec3> query_points(const PointSet& set) {
  std::vector<Vec3> queries = {Vec3(0), Vec3(-3, 7, 2), Vec3(0.5f)};
  Rng rng(99, 0, 0);
  for (int i = 0; i < 20 / GUIDELIGHT_SLOWDOWN; ++i) {
    const Vec3 jitter(rng.next_float(), rng.next_float(), rng.next_float());
    queries.push_back(jitter);
    if (set.points.empty()) continue;
    const Vec3 member = set.points[rng.next_uint() % set.points.size()].position;
    queries.push_back(member);
    queries.push_back(member + 0.02f * (jitter - 0.5f));
  }
  return queries;
}

}  // namespace guidelight::testing

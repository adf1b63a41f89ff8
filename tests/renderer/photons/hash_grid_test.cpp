#include "renderer/photons/hash_grid.h"

#include <gtest/gtest.h>

#include "tests/renderer/photons/point_sets.h"

namespace guidelight {
namespace {

using testing::TestPoint;

/// Ids within the radius, sorted; an id found twice stands there twice.
std::vector<uint32_t> found(const HashGrid<TestPoint>& grid, Vec3 center, float radius) {
  std::vector<uint32_t> ids;
  grid.for_each_within(center, radius, [&](const TestPoint& point, float squared) {
    EXPECT_FLOAT_EQ(squared, length_squared(point.position - center));
    ids.push_back(point.id);
  });
  std::sort(ids.begin(), ids.end());
  return ids;
}

std::vector<uint32_t> expected(const std::vector<TestPoint>& points, Vec3 center, float radius) {
  std::vector<uint32_t> ids;
  for (const TestPoint& point : points) {
    if (length_squared(point.position - center) < sqr(radius)) ids.push_back(point.id);
  }
  return ids;
}

TEST(HashGrid, finds_what_brute_force_finds) {
  Parallel parallel(2);
  for (const auto& set : testing::point_sets()) {
    for (const float cell_side : {0.1f, 0.003f, 5.0f}) {
      const HashGrid<TestPoint> grid(set.points, cell_side, parallel);
      for (const Vec3 center : testing::query_points(set)) {
        for (const float radius : {0.0f, 1e-4f, 0.05f, 0.13f, 10.0f}) {
          ASSERT_EQ(found(grid, center, radius), expected(set.points, center, radius))
              << set.name << ", cells of " << cell_side << ", radius " << radius;
        }
      }
    }
  }
}

TEST(HashGrid, cells_without_a_size_are_given_one) {
  Parallel parallel(2);
  const auto set = testing::point_sets()[3];
  for (const float side : {0.0f, -1.0f, std::numeric_limits<float>::quiet_NaN(), kInfinity}) {
    const HashGrid<TestPoint> grid(set.points, side, parallel);
    EXPECT_EQ(found(grid, Vec3(0.5f), 0.01f), expected(set.points, Vec3(0.5f), 0.01f));
  }
}

TEST(HashGrid, queries_that_mean_nothing_find_nothing) {
  Parallel parallel(2);
  const auto set = testing::point_sets()[3];
  const HashGrid<TestPoint> grid(set.points, 0.1f, parallel);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_TRUE(found(grid, Vec3(nan), 1).empty());
  EXPECT_TRUE(found(grid, Vec3(kInfinity, 0, 0), 1).empty());
  EXPECT_TRUE(found(grid, Vec3(0.5f), nan).empty());
  EXPECT_TRUE(found(grid, Vec3(0.5f), -1).empty());
  EXPECT_EQ(found(grid, Vec3(0.5f), kInfinity).size(), set.points.size());
  EXPECT_TRUE(found(HashGrid<TestPoint>(), Vec3(0), 1).empty());
}

TEST(HashGrid, order_does_not_depend_on_threads) {
  Rng rng(5, 0, 0);
  std::vector<TestPoint> points;
  for (uint32_t i = 0; i < 100000; ++i) {
    points.push_back({{rng.next_float(), rng.next_float(), 0}, i});
  }
  Parallel one(1), two(2);
  const HashGrid<TestPoint> a(points, 0.01f, one), b(points, 0.01f, two);
  for (size_t i = 0; i < points.size(); ++i) ASSERT_EQ(a.items()[i].id, b.items()[i].id);
}

}  // namespace
}  // namespace guidelight

#include "renderer/photons/kd_tree.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/renderer/photons/point_sets.h"

namespace guidelight {
namespace {

using ::testing::FloatEq;
using ::testing::Pointwise;
using testing::TestPoint;

/// Squared distances of the k nearest within the maximum distance, nearest first.
std::vector<float> expected(const std::vector<TestPoint>& points, Vec3 center, size_t k,
                            float max_distance) {
  std::vector<float> squared;
  for (const TestPoint& point : points) {
    const float d = length_squared(point.position - center);
    if (d < sqr(max_distance)) squared.push_back(d);
  }
  std::sort(squared.begin(), squared.end());
  squared.resize(std::min(squared.size(), k));
  return squared;
}

TEST(KdTree, finds_what_brute_force_finds) {
  Parallel parallel(2);
  std::vector<Neighbor> buffer(3000);
  for (const auto& set : testing::point_sets()) {
    const KdTree<TestPoint> tree(set.points, parallel);
    for (const Vec3 center : testing::query_points(set)) {
      for (const size_t k : {size_t{1}, size_t{60}, buffer.size()}) {
        for (const float max_distance : {0.0f, 0.05f, 2.0f, kInfinity}) {
          const Neighbors neighbors = tree.nearest(center, k, max_distance, buffer);
          std::vector<float> squared;
          std::vector<uint32_t> ids;
          for (const Neighbor& n : neighbors.found) {
            const TestPoint& point = tree.items()[n.index];
            ASSERT_FLOAT_EQ(n.distance_squared, length_squared(point.position - center));
            squared.push_back(n.distance_squared);
            ids.push_back(point.id);
          }
          std::sort(squared.begin(), squared.end());
          // Up to the rounding of sums that compilers may contract differently.
          ASSERT_THAT(squared, Pointwise(FloatEq(), expected(set.points, center, k, max_distance)))
              << set.name << ", k " << k << ", maximum distance " << max_distance;
          ASSERT_EQ(neighbors.radius_squared,
                    squared.size() == k ? squared.back() : sqr(max_distance));
          std::sort(ids.begin(), ids.end());
          ASSERT_EQ(std::adjacent_find(ids.begin(), ids.end()), ids.end()) << "found twice";
        }
      }
    }
  }
}

TEST(KdTree, searches_that_mean_nothing_find_nothing) {
  Parallel parallel(1);
  const KdTree<TestPoint> tree(testing::point_sets()[3].points, parallel);
  std::vector<Neighbor> buffer(10);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_TRUE(tree.nearest(Vec3(nan), 10, 1, buffer).found.empty());
  EXPECT_TRUE(tree.nearest(Vec3(0.5f), 10, nan, buffer).found.empty());
  EXPECT_TRUE(tree.nearest(Vec3(0.5f), 10, -1, buffer).found.empty());
  EXPECT_TRUE(tree.nearest(Vec3(0.5f), 0, 1, buffer).found.empty());
  EXPECT_EQ(tree.nearest(Vec3(0.5f), 100, 1, buffer).found.size(), buffer.size());
  EXPECT_TRUE(KdTree<TestPoint>().nearest(Vec3(0), 10, 1, buffer).found.empty());
}

TEST(KdTree, order_does_not_depend_on_threads) {
  Rng rng(5, 0, 0);
  std::vector<TestPoint> points;
  for (uint32_t i = 0; i < 100000; ++i) {
    points.push_back({{rng.next_float(), rng.next_float(), 0}, i});
  }
  Parallel one(1), two(2);
  const KdTree<TestPoint> a(points, one), b(points, two);
  ASSERT_EQ(a.items().size(), points.size());
  for (size_t i = 0; i < points.size(); ++i) ASSERT_EQ(a.items()[i].id, b.items()[i].id);
}

}  // namespace
}  // namespace guidelight

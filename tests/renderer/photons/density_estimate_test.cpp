#include "renderer/photons/density_estimate.h"

#include <gtest/gtest.h>

#include <array>

#include "renderer/photons/kd_tree.h"
#include "renderer/sampling/random.h"
#include "tests/statistics/hypothesis_tests.h"

namespace guidelight {
namespace {

constexpr Kernel kKernels[] = {Kernel::Constant, Kernel::Cone, Kernel::Epanechnikov};

TEST(DensityEstimate, kernels_integrate_to_one) {
  for (const Kernel kernel : kKernels) {
    const double radius = 0.7;
    const int steps = 100000;
    double integral = 0;
    for (int i = 0; i < steps; ++i) {
      const double d = radius * (i + 0.5) / steps;
      integral += 2 * M_PI * d * radius / steps *
                  kernel_value(kernel, static_cast<float>(d * d), static_cast<float>(sqr(radius)));
    }
    EXPECT_NEAR(integral, 1, 1e-4);
  }
}

TEST(DensityEstimate, rim_and_beyond_count_for_nothing) {
  for (const Kernel kernel : kKernels) {
    EXPECT_EQ(kernel_value(kernel, 4, 4), 0);
    EXPECT_EQ(kernel_value(kernel, 5, 4), 0);
    EXPECT_EQ(kernel_value(kernel, 0, 0), 0);
  }
}

TEST(DensityEstimate, nearest_neighbours_are_unbiased_where_photons_are_uniform) {
  // Many small sets of uniform photons, one estimate in the middle of each: the mean must be their
  // density. False alarms 1e-6 for all cases together.
  struct Point {
    Vec3 position;
  };
  constexpr int kPoints = 400;
  Parallel parallel(1);
  const double level = statistics::sidak_level(1e-6, 9);
  for (const Kernel kernel : kKernels) {
    for (const size_t k : {3, 10, 60}) {
      Rng rng(7, static_cast<uint64_t>(kernel), k);
      statistics::Moments moments;
      std::array<Neighbor, 60> buffer;
      for (int trial = 0; trial < 1000; ++trial) {
        std::vector<Point> points(kPoints);
        for (Point& p : points) p.position = Vec3(rng.next_vec2(), 0);
        const KdTree<Point> tree(points, parallel);
        const Neighbors neighbors = tree.nearest({0.5f, 0.5f, 0}, k, 1, buffer);
        double estimate = 0;
        for (const Neighbor& n : neighbors.found) {
          estimate += kernel_value(kernel, n.distance_squared, neighbors.radius_squared);
        }
        moments.add(estimate / kPoints);
      }
      // A fixed number of points is not quite a Poisson process: the reciprocal of a Beta variable
      // has the mean n/(k-1) as well, so nothing has to be allowed for.
      EXPECT_GT(statistics::t_test(moments, 1), level)
          << "kernel " << static_cast<int>(kernel) << ", k " << k << ": " << moments.mean();
    }
  }
}

TEST(DensityEstimate, surfaces_are_told_apart_by_their_normals) {
  EXPECT_TRUE(is_same_surface({0, 0, 1}, {0, 0, -1}));
  EXPECT_TRUE(is_same_surface({0, 0, 1}, glm::normalize(Vec3(0.3f, 0, 1))));
  EXPECT_FALSE(is_same_surface({0, 0, 1}, {1, 0, 0}));
}

}  // namespace
}  // namespace guidelight

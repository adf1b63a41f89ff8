#include "renderer/sampling/warp.h"

#include <gtest/gtest.h>

#include "renderer/sampling/random.h"
#include "tests/statistics/hypothesis_tests.h"
#include "tests/statistics/sphere_histogram.h"

namespace guidelight {
namespace {

constexpr int kWarpSamples = 200000;
constexpr int kTests = 9;
const double kWarpLevel = statistics::sidak_level(statistics::kFalseAlarms, kTests);

template <typename Warp, typename Density>
double sphere_p_value(uint64_t seed, Warp&& warp, Density&& density) {
  const statistics::SphereGrid grid;
  std::vector<double> observed(grid.size());
  Rng rng(seed, 0, 0);
  for (int i = 0; i < kWarpSamples; ++i) ++observed[grid.cell(warp(rng.next_vec2()))];
  std::vector<double> expected = grid.integrate(density);
  for (double& e : expected) e *= kWarpSamples;
  return statistics::chi_square_test(observed, expected).p_value;
}

TEST(Warp, CosineHemisphere) {
  EXPECT_GT(sphere_p_value(1, square_to_cosine_hemisphere,
                           [](Vec3 w) { return cosine_hemisphere_pdf(w.z); }),
            kWarpLevel);
}

TEST(Warp, UniformSphere) {
  EXPECT_GT(sphere_p_value(2, square_to_sphere, [](Vec3) { return kUniformSpherePdf; }),
            kWarpLevel);
}

TEST(Warp, UniformCap) {
  int i = 0;
  for (const float cos_max : {0.8f, 0.2f, -0.6f}) {  // edges of the grid's cells
    const auto warp = [&](Vec2 u) { return square_to_cap(u, cos_max); };
    const auto density = [&](Vec3 w) { return w.z > cos_max ? uniform_cap_pdf(cos_max) : 0.0f; };
    EXPECT_GT(sphere_p_value(3 + i++, warp, density), kWarpLevel) << cos_max;
  }
}

TEST(Warp, NarrowCapKeepsItsPrecision) {
  // Within a cap of 1e-5 rad, cosθ rounds to 1; the tangent of θ must still be uniform in its
  // square.
  const float one_minus_cos_max = 0.5e-10f;
  statistics::Moments squares;
  Rng rng(6, 0, 0);
  for (int i = 0; i < kWarpSamples; ++i) {
    const Vec3 w = square_to_narrow_cap(rng.next_vec2(), one_minus_cos_max);
    squares.add((sqr(double(w.x)) + sqr(double(w.y))) / 1e-10);
  }
  EXPECT_GT(statistics::t_test(squares, 0.5, 1e-6), kWarpLevel);
  EXPECT_NEAR(narrow_cap_pdf(one_minus_cos_max) * kPi * 1e-10, 1, 1e-4);
}

/// Counts in a grid over [0,1)² where the density is expected to be constant.
template <typename Warp>
double square_p_value(uint64_t seed, Warp&& warp) {
  constexpr int kCells = 20;
  std::vector<double> observed(kCells * kCells);
  Rng rng(seed, 0, 0);
  for (int i = 0; i < kWarpSamples; ++i) {
    const Vec2 p = warp(rng.next_vec2());
    const int x = std::min(static_cast<int>(p.x * kCells), kCells - 1);
    const int y = std::min(static_cast<int>(p.y * kCells), kCells - 1);
    ++observed.at(static_cast<size_t>(y) * kCells + x);
  }
  const std::vector<double> expected(observed.size(),
                                     static_cast<double>(kWarpSamples) / observed.size());
  return statistics::chi_square_test(observed, expected).p_value;
}

TEST(Warp, DiskIsUniform) {
  // The inverse of the polar map with equal areas takes a uniform disc to a uniform square.
  EXPECT_GT(square_p_value(7,
                           [](Vec2 u) {
                             const Vec2 d = square_to_disk(u);
                             return Vec2(glm::dot(d, d), std::atan2(d.y, d.x) / (2 * kPi) + 0.5f);
                           }),
            kWarpLevel);
}

TEST(Warp, TriangleIsUniform) {
  // Likewise for a triangle: (1-b0)² and b2/(1-b0) are independent and uniform.
  EXPECT_GT(square_p_value(8,
                           [](Vec2 u) {
                             const Vec2 b = square_to_triangle(u);
                             const float sum = b.x + b.y;
                             return Vec2(sum * sum, b.y / sum);
                           }),
            kWarpLevel);
}

}  // namespace
}  // namespace guidelight

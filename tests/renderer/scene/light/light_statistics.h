#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "renderer/sampling/random.h"
#include "tests/statistics/hypothesis_tests.h"
#include "tests/statistics/sphere_histogram.h"

/// Whether directions are drawn with the density that a light tells.
namespace guidelight::light_test {

inline constexpr int kParts = 24;

/// Integral over every cell of a grid, from one random point in each of 24² parts of equal solid
/// angle: makes no systematic error where the function jumps at a light's outline.
template <typename Function>
std::vector<double> integrate(const statistics::SphereGrid& grid, Function&& function) {
  constexpr int kCosines = 20 * kParts, kAzimuths = 40 * kParts;
  std::vector<double> integrals(grid.size());
  Rng rng(98, 0, 0);
  for (int i = 0; i < kCosines; ++i) {
    for (int j = 0; j < kAzimuths; ++j) {
      const float z = -1 + (static_cast<float>(i) + rng.next_float()) * 2 / kCosines;
      const float phi = (static_cast<float>(j) + rng.next_float()) * 2 * kPi / kAzimuths;
      const Vec3 w(safe_sqrt(1 - z * z) * std::cos(phi), safe_sqrt(1 - z * z) * std::sin(phi), z);
      integrals[grid.cell(w)] += 4 * std::numbers::pi * function(w) / (kCosines * kAzimuths);
    }
  }
  return integrals;
}

/// False alarm rate of each of the tests over all its lights.
inline constexpr double kFamilyLevel = 1e-3;

/// A direction and the density with which it was drawn; density 0 is a sample that was dropped.
struct DrawnDirection {
  Vec3 w{0};
  float pdf = 0;
};

/// 1/pdf, averaged over the samples in a cell of directions, is the solid angle of that part of the
/// cell that can be sampled; `can_sample(w)` says which. (Where densities are infinite, though
/// integrable, as at the outline of a curved light that is sampled by area, counts could not be
/// compared with integrals.)
template <typename Draw, typename CanSample>
void expect_solid_angles(Draw&& draw, CanSample&& can_sample, size_t tests) {
  const statistics::SphereGrid grid;
  const double cell_size = 4 * std::numbers::pi / static_cast<double>(grid.size());
  // Of the reference: three standard deviations where an outline crosses all parts of a row.
  const double tolerance = 3 * 0.5 * std::pow(kParts, -1.5) * cell_size;
  const std::vector<double> expected = integrate(grid, can_sample);

  constexpr int kSamples = 60000;
  std::vector<std::pair<double, double>> sums(grid.size());  // of 1/pdf and its square
  Rng rng(1, 0, 0);
  for (int i = 0; i < kSamples; ++i) {
    const DrawnDirection drawn = draw(rng);
    if (drawn.pdf == 0) continue;
    auto& [sum, squares] = sums[grid.cell(drawn.w)];
    sum += 1 / drawn.pdf;
    squares += sqr(1.0 / drawn.pdf);
  }
  const double level = statistics::sidak_level(kFamilyLevel, tests * grid.size());
  for (size_t i = 0; i < grid.size(); ++i) {
    const double mean = sums[i].first / kSamples;
    const double error = std::sqrt((sums[i].second / kSamples - sqr(mean)) / kSamples);
    const double excess = std::max(0.0, std::abs(mean - expected[i]) - tolerance);
    if (excess == 0) continue;
    ASSERT_GT(statistics::student_t_p_value(excess / error, kSamples - 1), level)
        << "cell " << i << ": " << mean << " for " << expected[i];
  }
}

/// Directions of a density that is bounded are compared with it by a chi-square test.
template <typename Draw, typename Density>
void expect_distribution(Draw&& draw, Density&& density, uint64_t seed, double level) {
  const statistics::SphereGrid grid;
  constexpr int kSamples = 60000;
  std::vector<double> observed(grid.size());
  Rng rng(seed, 0, 0);
  for (int i = 0; i < kSamples; ++i) ++observed[grid.cell(draw(rng))];
  std::vector<double> expected = integrate(grid, density);
  double total = 0;
  for (const double e : expected) total += e;
  EXPECT_NEAR(total, 1, 2e-3);
  for (double& e : expected) e *= kSamples / total;
  EXPECT_GT(statistics::chi_square_test(observed, expected).p_value, level);
}

}  // namespace guidelight::light_test

#include "renderer/image/filter.h"

#include <gtest/gtest.h>

#include "renderer/sampling/random.h"
#include "tests/statistics/hypothesis_tests.h"

namespace guidelight {
namespace {

struct FilterCase {
  const char* name;
  FilterSettings settings;
  float radius;
};

const FilterCase kFilterCases[] = {
    {"box", {FilterKind::Box}, 0.5f},
    {"wide_box", {FilterKind::Box, 1.5f}, 1.5f},
    {"tent", {FilterKind::Tent}, 1},
    {"gaussian", {FilterKind::Gaussian}, 2},
    {"cut_gaussian", {FilterKind::Gaussian, 1, 1}, 1},
    {"mitchell", {FilterKind::Mitchell}, 2},
    {"catmull_rom", {FilterKind::Mitchell, 0, 0.5f, 0, 0.5f}, 2},
};

const double kFilterLevel = statistics::sidak_level(1e-3, 2 * std::size(kFilterCases));

class FilterSampling : public ::testing::TestWithParam<FilterCase> {};

constexpr int kFilterCells = 40;  // along each axis

TEST_P(FilterSampling, OffsetsAreDistributedLikeTheFilter) {
  const Filter filter(GetParam().settings);
  const float radius = GetParam().radius;
  ASSERT_FLOAT_EQ(filter.radius(), radius);

  // Expected: ∫|f| over each cell, from a fine midpoint rule.
  constexpr int kFine = 16;
  std::vector<double> expected(kFilterCells * kFilterCells);
  const float step = 2 * radius / (kFilterCells * kFine);
  double integral = 0, absolute = 0;
  for (int y = 0; y < kFilterCells * kFine; ++y) {
    for (int x = 0; x < kFilterCells * kFine; ++x) {
      const double f = filter.eval(Vec2(x + 0.5f, y + 0.5f) * step - radius) * sqr(double(step));
      integral += f;
      absolute += std::abs(f);
      expected[y / kFine * kFilterCells + x / kFine] += std::abs(f);
    }
  }
  EXPECT_NEAR(integral, 1, 1e-4);

  constexpr int kSamples = 400000;
  std::vector<double> observed(expected.size());
  statistics::Moments weights;
  Rng rng(1, 0, 0);
  for (int i = 0; i < kSamples; ++i) {
    const Filter::Sample sample = filter.sample(rng.next_vec2());
    const Vec2 cell = (sample.offset + radius) / (2 * radius) * float(kFilterCells);
    ASSERT_NEAR(std::abs(sample.weight), absolute, 1e-3);
    weights.add(sample.weight);
    ++observed.at(std::min(int(cell.y), kFilterCells - 1) * kFilterCells +
                  std::min(int(cell.x), kFilterCells - 1));
  }
  for (double& e : expected) e *= kSamples / absolute;
  EXPECT_GT(statistics::chi_square_test(observed, expected).p_value, kFilterLevel);
  // A constant picture stays what it is.
  if (weights.variance() > 0) {
    EXPECT_GT(statistics::t_test(weights, 1, 1e-4), kFilterLevel);
  }
}

INSTANTIATE_TEST_SUITE_P(All, FilterSampling, ::testing::ValuesIn(kFilterCases),
                         [](const auto& test) { return test.param.name; });

TEST(Filter, TruncatedGaussianEndsAtZero) {
  const Filter filter(FilterSettings{FilterKind::Gaussian, 1, 1});
  EXPECT_NEAR(filter.eval({0.99999f, 0}), 0, 1e-4f);
  EXPECT_EQ(filter.eval({1.01f, 0}), 0);
}

}  // namespace
}  // namespace guidelight

#include "renderer/sampling/distribution.h"

#include <gtest/gtest.h>

#include "renderer/sampling/random.h"
#include "tests/statistics/hypothesis_tests.h"

namespace guidelight {
namespace {

constexpr int kDistributionSamples = 200000;
const double kDistributionLevel = statistics::sidak_level(1e-3, 3);

TEST(DiscreteDistribution, FollowsItsWeights) {
  const std::vector<float> weights = {1, 0, 3, 0.5f, 0, 10, 2};
  const DiscreteDistribution distribution(weights);
  EXPECT_DOUBLE_EQ(distribution.total(), 16.5);
  std::vector<double> observed(weights.size()), expected(weights.size());
  statistics::Moments remapped;
  Rng rng(1, 0, 0);
  for (int i = 0; i < kDistributionSamples; ++i) {
    const auto sample = distribution.sample(rng.next_float());
    ASSERT_GT(weights[sample.index], 0);
    ASSERT_EQ(sample.pmf, distribution.pmf(sample.index));
    ASSERT_GE(sample.remapped, 0);
    ASSERT_LT(sample.remapped, 1);
    ++observed[sample.index];
    remapped.add(sample.remapped);
  }
  for (size_t i = 0; i < weights.size(); ++i) {
    EXPECT_NEAR(distribution.pmf(i), weights[i] / 16.5, 1e-6);
    expected[i] = kDistributionSamples * weights[i] / 16.5;
  }
  EXPECT_GT(statistics::chi_square_test(observed, expected).p_value, kDistributionLevel);
  EXPECT_GT(statistics::t_test(remapped, 0.5, 1e-6), kDistributionLevel);
}

TEST(DiscreteDistribution, WithoutWeightIsUniform) {
  const DiscreteDistribution distribution(std::vector<float>(4, 0.0f));
  for (uint32_t i = 0; i < 4; ++i) {
    EXPECT_FLOAT_EQ(distribution.pmf(i), 0.25f);
    EXPECT_EQ(distribution.sample(0.25f * i + 0.1f).index, i);
  }
}

TEST(GridDistribution, FollowsItsValues) {
  constexpr int kWidth = 7, kHeight = 5;
  std::vector<float> values(kWidth * kHeight);
  double total = 0;
  Rng rng(2, 0, 0);
  for (float& v : values) total += v = rng.next_float() < 0.3f ? 0 : sqr(4 * rng.next_float());
  const GridDistribution grid(values, kWidth, kHeight);
  std::vector<double> observed(values.size()), expected(values.size());
  for (int i = 0; i < kDistributionSamples; ++i) {
    const auto sample = grid.sample(rng.next_vec2());
    ASSERT_NEAR(sample.pdf, grid.pdf(sample.position), 1e-5f * sample.pdf);
    ++observed[static_cast<int>(sample.position.y * kHeight) * kWidth +
               static_cast<int>(sample.position.x * kWidth)];
  }
  for (size_t i = 0; i < values.size(); ++i) expected[i] = kDistributionSamples * values[i] / total;
  EXPECT_GT(statistics::chi_square_test(observed, expected).p_value, kDistributionLevel);
}

}  // namespace
}  // namespace guidelight

#include <gtest/gtest.h>

#include "renderer/sampling/random.h"
#include "renderer/sampling/warp.h"
#include "tests/statistics/hypothesis_tests.h"
#include "tests/statistics/special_functions.h"
#include "tests/statistics/sphere_histogram.h"

namespace guidelight::statistics {
namespace {

// Reference values are closed forms or from published tables of the distributions.

TEST(SpecialFunctions, IncompleteGammaHasItsClosedForms) {
  for (const double x : {0.1, 1.0, 3.0, 20.0}) {
    EXPECT_NEAR(incomplete_gamma_upper(1, x), std::exp(-x), 1e-12);
    EXPECT_NEAR(incomplete_gamma_upper(0.5, x), std::erfc(std::sqrt(x)), 1e-12);
    EXPECT_NEAR(incomplete_gamma_upper(3, x), std::exp(-x) * (1 + x + x * x / 2), 1e-12);
  }
}

TEST(SpecialFunctions, IncompleteBetaHasItsClosedForms) {
  for (const double x : {0.01, 0.3, 0.5, 0.9}) {
    EXPECT_NEAR(incomplete_beta(1, 1, x), x, 1e-12);
    EXPECT_NEAR(incomplete_beta(2, 1, x), x * x, 1e-12);
    EXPECT_NEAR(incomplete_beta(1, 3, x), 1 - std::pow(1 - x, 3), 1e-12);
    EXPECT_NEAR(incomplete_beta(0.5, 0.5, x), 2 / std::numbers::pi * std::asin(std::sqrt(x)),
                1e-12);
  }
}

TEST(HypothesisTests, StudentsTableIsReproduced) {
  EXPECT_NEAR(student_t_p_value(12.706, 1), 0.05, 1e-5);
  EXPECT_NEAR(student_t_p_value(2.228, 10), 0.05, 1e-4);
  EXPECT_NEAR(student_t_p_value(2.576, 1e6), 0.01, 1e-4);
}

TEST(HypothesisTests, SidakLevelsMultiplyToTheFamilyLevel) {
  EXPECT_NEAR(std::pow(1 - sidak_level(0.01, 37), 37), 0.99, 1e-12);
  EXPECT_DOUBLE_EQ(sidak_level(0.01, 1), 0.01);
}

TEST(ChiSquareTest, StatisticOfAnExampleByHand) {
  const double observed[] = {44, 56};
  const double expected[] = {50, 50};
  const ChiSquare result = chi_square_test(observed, expected);
  EXPECT_DOUBLE_EQ(result.statistic, 1.44);
  EXPECT_EQ(result.degrees_of_freedom, 1u);
  EXPECT_NEAR(result.p_value, 0.2301, 1e-4);
}

TEST(ChiSquareTest, CellsWithLowExpectationArePooled) {
  const double observed[] = {1, 2, 0, 3, 94};
  const double expected[] = {1.5, 1.5, 1.5, 1.5, 94};
  const ChiSquare result = chi_square_test(observed, expected);
  EXPECT_DOUBLE_EQ(result.statistic, 0);  // 6 against 6, 94 against 94
  EXPECT_EQ(result.degrees_of_freedom, 1u);
}

TEST(ChiSquareTest, CountsWhereNothingIsExpectedAreRejectedUnlessTheyAreRoundingErrors) {
  const double expected[] = {50000, 50000, 0};
  const double wrong[] = {50000, 49998, 2};
  EXPECT_EQ(chi_square_test(wrong, expected).p_value, 0);
  const double rounded[] = {50000, 49999, 1};
  EXPECT_GT(chi_square_test(rounded, expected).p_value, 0.9);
}

TEST(ChiSquareTest, PValuesOfATrueHypothesisAreUniform) {
  // 1000 tests of a fair die; the p-values go through the same test (false alarm rate 1e-3).
  constexpr int kTests = 1000;
  std::vector<double> decile_counts(10);
  Rng rng(1, 0, 0);
  for (int test = 0; test < kTests; ++test) {
    std::vector<double> counts(20);
    for (int i = 0; i < 2000; ++i) ++counts[static_cast<size_t>(rng.next_float() * 20)];
    const double p = chi_square_test(counts, std::vector<double>(20, 100.0)).p_value;
    ++decile_counts[std::min<size_t>(9, static_cast<size_t>(p * 10))];
  }
  EXPECT_GT(chi_square_test(decile_counts, std::vector<double>(10, kTests / 10.0)).p_value, 1e-3);
}

TEST(TTest, FindsAWrongMeanAndAcceptsTheRightOne) {
  Rng rng(2, 0, 0);
  Moments uniform;
  Moments squared;
  for (int i = 0; i < 20000; ++i) {
    uniform.add(rng.next_float());
    squared.add(sqr(rng.next_float()));
  }
  EXPECT_NEAR(uniform.variance(), 1.0 / 12, 1e-3);
  EXPECT_GT(t_test(uniform, 0.5), 1e-3);
  EXPECT_LT(t_test(uniform, 0.51), 1e-3);
  EXPECT_EQ(t_test(uniform, 0.51, 0.02), 1);
  EXPECT_LT(welch_test(uniform, squared), 1e-9);
  Moments again;
  for (int i = 0; i < 5000; ++i) again.add(rng.next_float());
  EXPECT_GT(welch_test(uniform, again), 1e-3);
}

double chi_square_of_cosine_hemisphere(double error) {
  constexpr int kSamples = 100000;
  const SphereGrid grid;
  std::vector<double> counts(grid.size());
  Rng rng(3, 0, 0);
  for (int i = 0; i < kSamples; ++i)
    ++counts[grid.cell(square_to_cosine_hemisphere(rng.next_vec2()))];
  std::vector<double> expected = grid.integrate(
      [error](Vec3 w) { return cosine_hemisphere_pdf(w.z) * (1 + error * (w.z - 2.0 / 3)); });
  for (double& e : expected) e *= kSamples;
  return chi_square_test(counts, expected).p_value;
}

TEST(SphereGrid, TrueDensityPassesAndADensityWrongByPercentsDoesNot) {
  EXPECT_GT(chi_square_of_cosine_hemisphere(0), 1e-3);
  // 7 % too much at the pole, 13 % too little at the horizon, and the right total.
  EXPECT_LT(chi_square_of_cosine_hemisphere(0.2), 1e-3);
}

TEST(SphereGrid, IntegratesDensitiesThatJump) {
  // Solid angle of a tilted hemisphere and of a small tilted cap of cosine 0.99.
  const Vec3 axis = glm::normalize(Vec3(1, 2, 3));
  const auto total = [&](float cos_min) {
    const SphereGrid grid;
    double sum = 0;
    for (const double i : grid.integrate([&](Vec3 w) { return glm::dot(w, axis) > cos_min; })) {
      sum += i;
    }
    return sum;
  };
  EXPECT_NEAR(total(0), 2 * std::numbers::pi, 2e-3);
  EXPECT_NEAR(total(0.99f), 2 * std::numbers::pi * 0.01, 2e-4);
}

}  // namespace
}  // namespace guidelight::statistics

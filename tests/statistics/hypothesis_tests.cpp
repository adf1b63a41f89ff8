#include "tests/statistics/hypothesis_tests.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "tests/statistics/special_functions.h"

namespace guidelight::statistics {
namespace {

/// t of a difference of means, after what the tolerance excuses.
double t_statistic(double difference, double standard_error, double tolerance) {
  const double excess = std::max(0.0, std::abs(difference) - tolerance);
  if (excess == 0) return 0;
  return standard_error > 0 ? excess / standard_error : HUGE_VAL;
}

}  // namespace

double sidak_level(double family_level, size_t tests) {
  return -std::expm1(std::log1p(-family_level) / static_cast<double>(tests));
}

ChiSquare chi_square_test(std::span<const double> observed, std::span<const double> expected,
                          double min_expected) {
  std::vector<size_t> order(expected.size());
  std::iota(order.begin(), order.end(), size_t{0});
  std::ranges::sort(order, {}, [&](size_t i) { return expected[i]; });

  double total = 0;
  double impossible = 0;
  for (size_t i = 0; i < observed.size(); ++i) {
    total += observed[i];
    if (expected[i] == 0) impossible += observed[i];
  }
  if (impossible > 1e-5 * total) return {HUGE_VAL, 0, 0.0};

  ChiSquare result;
  size_t cells = 0;
  double pooled_observed = 0;
  double pooled_expected = 0;
  const auto close_cell = [&] {
    const double difference = pooled_observed - pooled_expected;
    result.statistic += difference * difference / pooled_expected;
    ++cells;
    pooled_observed = pooled_expected = 0;
  };
  for (const size_t i : order) {
    pooled_observed += observed[i];
    pooled_expected += expected[i];
    if (pooled_expected >= min_expected) close_cell();
  }
  if (pooled_expected > 0) close_cell();
  if (cells < 2) return result;
  result.degrees_of_freedom = cells - 1;
  result.p_value =
      incomplete_gamma_upper(0.5 * static_cast<double>(cells - 1), 0.5 * result.statistic);
  return result;
}

double Moments::standard_error() const {
  return count_ > 0 ? std::sqrt(variance() / static_cast<double>(count_)) : 0;
}

double student_t_p_value(double t, double degrees_of_freedom) {
  if (!std::isfinite(t)) return 0;
  return incomplete_beta(0.5 * degrees_of_freedom, 0.5,
                         degrees_of_freedom / (degrees_of_freedom + t * t));
}

double t_test(const Moments& samples, double expected, double tolerance) {
  const double t = t_statistic(samples.mean() - expected, samples.standard_error(), tolerance);
  return student_t_p_value(t, static_cast<double>(samples.count()) - 1);
}

double welch_test(const Moments& a, const Moments& b, double tolerance) {
  const double va = a.variance() / static_cast<double>(a.count());
  const double vb = b.variance() / static_cast<double>(b.count());
  const double t = t_statistic(a.mean() - b.mean(), std::sqrt(va + vb), tolerance);
  if (va + vb == 0) return t == 0 ? 1 : 0;
  // Welch–Satterthwaite.
  const double degrees = (va + vb) * (va + vb) /
                         (va * va / (static_cast<double>(a.count()) - 1) +
                          vb * vb / (static_cast<double>(b.count()) - 1));
  return student_t_p_value(t, degrees);
}

}  // namespace guidelight::statistics

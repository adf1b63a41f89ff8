#pragma once

#include <cstddef>
#include <span>

/// Tests of "these random numbers are distributed like that". Each returns the p-value: how often a
/// correct sampler would look at least as wrong. A test rejects if it is below a significance level
/// that is the rate of false alarms; a family of tests corrects the level with `sidak_level`.
namespace guidelight::statistics {

/// Level for each of `tests` independent tests such that all of them together raise a false alarm
/// with probability `family_level` (Šidák 1967).
double sidak_level(double family_level, size_t tests);

/// How often a family of tests may raise a false alarm.
inline constexpr double kFalseAlarms = 1e-3;

struct ChiSquare {
  double statistic = 0;
  size_t degrees_of_freedom = 0;
  double p_value = 1;
};

/// Pearson's goodness-of-fit test of counts against expected counts of the same total. Cells that
/// expect fewer than `min_expected` are pooled, smallest first, until the pool expects that many.
ChiSquare chi_square_test(std::span<const double> observed, std::span<const double> expected,
                          double min_expected = 5);

/// Running mean and unbiased variance (Welford 1962).
class Moments {
 public:
  void add(double x) {
    ++count_;
    const double delta = x - mean_;
    mean_ += delta / static_cast<double>(count_);
    sum_squares_ += delta * (x - mean_);
  }
  size_t count() const { return count_; }
  double mean() const { return mean_; }
  double variance() const {
    return count_ > 1 ? sum_squares_ / (static_cast<double>(count_) - 1) : 0;
  }
  double standard_error() const;

 private:
  size_t count_ = 0;
  double mean_ = 0;
  double sum_squares_ = 0;
};

/// Two-sided p-value of Student's t with the given degrees of freedom.
double student_t_p_value(double t, double degrees_of_freedom);

/// Two-sided t-test: is the mean of the samples `expected`? `tolerance` is a systematic error of
/// the expectation that is allowed for (rounding, quadrature).
double t_test(const Moments& samples, double expected, double tolerance = 0);

/// Welch's two-sided t-test: do two sets of samples have the same mean?
double welch_test(const Moments& a, const Moments& b, double tolerance = 0);

}  // namespace guidelight::statistics

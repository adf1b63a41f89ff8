#include "tests/statistics/special_functions.h"

#include <cmath>

namespace guidelight::statistics {
namespace {

constexpr int kMaxTerms = 10000;
constexpr double kPrecision = 1e-14;
constexpr double kTiny = 1e-300;

/// P(a, x) by its power series (Abramowitz & Stegun 6.5.29); converges fast for x < a + 1.
double gamma_series(double a, double x) {
  double term = 1 / a;
  double sum = term;
  for (int n = 1; n < kMaxTerms && std::abs(term) > kPrecision * sum; ++n) {
    term *= x / (a + n);
    sum += term;
  }
  return sum * std::exp(a * std::log(x) - x - std::lgamma(a));
}

/// Evaluates b0 + a1/(b1 + a2/(b2 + …)) by Lentz's method; coefficient(n) returns {a_n, b_n}.
template <typename Coefficient>
double continued_fraction(double b0, Coefficient coefficient) {
  double f = b0 == 0 ? kTiny : b0;
  double c = f;
  double d = 0;
  for (int n = 1; n < kMaxTerms; ++n) {
    const auto [a, b] = coefficient(n);
    d = b + a * d;
    c = b + a / c;
    if (d == 0) d = kTiny;
    if (c == 0) c = kTiny;
    d = 1 / d;
    f *= c * d;
    if (std::abs(c * d - 1) < kPrecision) break;
  }
  return f;
}

struct Term {
  double a;
  double b;
};

}  // namespace

double incomplete_gamma_upper(double a, double x) {
  if (x <= 0) return 1;
  if (x < a + 1) return 1 - gamma_series(a, x);
  // Abramowitz & Stegun 6.5.31, even part.
  const double f = continued_fraction(x + 1 - a, [a, x](int n) {
    return Term{-n * (n - a), x + 2 * n + 1 - a};
  });
  return std::exp(a * std::log(x) - x - std::lgamma(a)) / f;
}

double incomplete_beta(double a, double b, double x) {
  if (x <= 0) return 0;
  if (x >= 1) return 1;
  if (x > (a + 1) / (a + b + 2)) return 1 - incomplete_beta(b, a, 1 - x);
  // Abramowitz & Stegun 26.5.8.
  const double f = continued_fraction(1, [a, b, x](int n) {
    const int m = n / 2;
    const double numerator = n % 2 == 0
                                 ? m * (b - m) * x / ((a + 2 * m - 1) * (a + 2 * m))
                                 : -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1));
    return Term{numerator, 1};
  });
  const double log_front =
      a * std::log(x) + b * std::log1p(-x) + std::lgamma(a + b) - std::lgamma(a) - std::lgamma(b);
  return std::exp(log_front) / (a * f);
}

}  // namespace guidelight::statistics

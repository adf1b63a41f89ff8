#pragma once

namespace guidelight::statistics {

/// Upper regularised incomplete gamma function Q(a, x), a > 0, x ≥ 0.
double incomplete_gamma_upper(double a, double x);

/// Regularised incomplete beta function I_x(a, b), a, b > 0, x in [0,1].
double incomplete_beta(double a, double b, double x);

}  // namespace guidelight::statistics

#pragma once

#include <span>
#include <vector>

#include "renderer/math/vector.h"

namespace guidelight::statistics {

/// Cells of equal solid angle on the sphere: a grid over (cosθ, φ) around +z.
class SphereGrid {
 public:
  explicit SphereGrid(int cosines = 20, int azimuths = 40)
      : cosines_(cosines), azimuths_(azimuths) {}

  size_t size() const { return static_cast<size_t>(cosines_) * azimuths_; }
  /// Cell of a unit direction.
  size_t cell(Vec3 w) const;

  /// Integral of a density per solid angle over every cell, by adaptive Gauss quadrature down to an
  /// absolute error of about `tolerance` per cell. Also follows densities that jump.
  template <typename Density>
  std::vector<double> integrate(Density&& density, double tolerance = 1e-6) const;

 private:
  struct Rectangle {
    double cos_min, cos_max, phi_min, phi_max;
    Rectangle quarter(int i) const;
  };
  Rectangle rectangle(size_t cell) const;

  template <typename Density>
  static double estimate(Density& density, const Rectangle& r);
  template <typename Density>
  static double refine(Density& density, const Rectangle& r, double coarse, double tolerance,
                       int depth);

  int cosines_;
  int azimuths_;
};

// ---------------------------------------------------------------------------------------------------

inline SphereGrid::Rectangle SphereGrid::Rectangle::quarter(int i) const {
  const double cos_mid = 0.5 * (cos_min + cos_max);
  const double phi_mid = 0.5 * (phi_min + phi_max);
  return {i & 1 ? cos_mid : cos_min, i & 1 ? cos_max : cos_mid, i & 2 ? phi_mid : phi_min,
          i & 2 ? phi_max : phi_mid};
}

template <typename Density>
std::vector<double> SphereGrid::integrate(Density&& density, double tolerance) const {
  std::vector<double> integrals(size());
  for (size_t i = 0; i < size(); ++i) {
    const Rectangle r = rectangle(i);
    integrals[i] = refine(density, r, estimate(density, r), tolerance, 0);
  }
  return integrals;
}

template <typename Density>
double SphereGrid::estimate(Density& density, const Rectangle& r) {
  // Three-point Gauss–Legendre in both directions.
  constexpr double kNodes[3] = {0.1127016653792583, 0.5, 0.8872983346207417};
  constexpr double kWeights[3] = {5.0 / 18, 8.0 / 18, 5.0 / 18};
  double z[3], sin_theta[3];
  for (int i = 0; i < 3; ++i) {
    z[i] = r.cos_min + (r.cos_max - r.cos_min) * kNodes[i];
    sin_theta[i] = std::sqrt(std::max(0.0, 1 - z[i] * z[i]));
  }
  double sum = 0;
  for (int j = 0; j < 3; ++j) {
    const double phi = r.phi_min + (r.phi_max - r.phi_min) * kNodes[j];
    const double cos_phi = std::cos(phi);
    const double sin_phi = std::sin(phi);
    for (int i = 0; i < 3; ++i) {
      const Vec3 w(sin_theta[i] * cos_phi, sin_theta[i] * sin_phi, z[i]);
      sum += kWeights[i] * kWeights[j] * density(w);
    }
  }
  return sum * (r.cos_max - r.cos_min) * (r.phi_max - r.phi_min);
}

template <typename Density>
double SphereGrid::refine(Density& density, const Rectangle& r, double coarse, double tolerance,
                          int depth) {
  constexpr int kMaxDepth = 6;
  constexpr int kMinDepth = 1;    // a narrow peak may hide from the first points
  constexpr int kEmptyDepth = 2;  // and a sliver from the next
  double parts[4];
  double fine = 0;
  for (int i = 0; i < 4; ++i) fine += parts[i] = estimate(density, r.quarter(i));
  const bool is_settled =
      std::abs(fine - coarse) < tolerance && depth >= (fine > 0 ? kMinDepth : kEmptyDepth);
  if (is_settled || depth == kMaxDepth) return fine;
  double sum = 0;
  for (int i = 0; i < 4; ++i) {
    sum += refine(density, r.quarter(i), parts[i], 0.5 * tolerance, depth + 1);
  }
  return sum;
}

}  // namespace guidelight::statistics

#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "renderer/scene/bsdf/bsdf.h"

namespace guidelight::bsdf_test {

/// Every BSDF model, in the variants that the general tests (sampling, energy, reciprocity) go
/// through.
struct Case {
  std::string name;
  std::vector<BsdfDescription> bsdfs;  // the last is the one to test, the others are nested in it

  std::shared_ptr<const Bsdf> build() const;
};

std::vector<Case> all_cases();

/// Builds a scene's last BSDF from models, each of which may refer to those before it.
template <typename... Models>
std::vector<BsdfDescription> chain(Models... models) {
  std::vector<BsdfDescription> bsdfs;
  (bsdfs.push_back({.name = "test", .line = 0, .model = std::move(models)}), ...);
  return bsdfs;
}

template <typename... Models>
std::shared_ptr<const Bsdf> build(Models... models) {
  return Case{"", chain(std::move(models)...)}.build();
}

/// A surface point at the origin with all frames along the axes.
inline SurfacePoint flat_point(const Bsdf& bsdf) {
  SurfacePoint point;
  point.dpdu = Vec3(1, 0, 0);
  point.dpdv = Vec3(0, 1, 0);
  point.bsdf = &bsdf;
  return point;
}

inline Vec3 direction(float theta_degrees, float phi_degrees) {
  const float theta = theta_degrees * kPi / 180;
  const float phi = phi_degrees * kPi / 180;
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

inline void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

}  // namespace guidelight::bsdf_test

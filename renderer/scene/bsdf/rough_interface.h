#pragma once

#include <vector>

#include "renderer/scene/bsdf/microfacet.h"

namespace guidelight {

/// What a rough dielectric interface lets through in one scattering event, all directions together,
/// tabulated by quadrature over the visible normals when it is built.
class RoughInterface {
 public:
  /// eta: IOR behind the interface over IOR in front of it. The table covers the given range of
  /// roughness, one row if it is a single value.
  RoughInterface(Microfacet kind, float eta, float alpha_min, float alpha_max);

  /// Share of light from direction cosθ > 0 in front that ends up behind.
  float transmittance(float cos_theta, float alpha) const;

 private:
  float row_value(int row, float cos_theta) const;

  float alpha_min_;
  float alpha_max_;
  int rows_;
  std::vector<float> table_;  // rows over roughness, each over cosθ
};

/// Share of diffuse light from the front that an interface of this roughness reflects back to the
/// front in one scattering event.
float diffuse_rough_reflectance(Microfacet kind, float eta, float alpha);

}  // namespace guidelight

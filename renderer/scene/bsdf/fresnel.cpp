#include "renderer/scene/bsdf/fresnel.h"

namespace guidelight {

float diffuse_fresnel_reflectance(float eta) {
  constexpr int kSteps = 4096;
  double sum = 0;
  for (int i = 0; i < kSteps; ++i) {
    const float cos2 = (i + 0.5f) / kSteps;  // 2μ dμ = d(μ²)
    sum += fresnel_dielectric(std::sqrt(cos2), eta).reflectance;
  }
  return static_cast<float>(sum / kSteps);
}

}  // namespace guidelight

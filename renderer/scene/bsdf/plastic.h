#pragma once

#include "renderer/scene/bsdf/two_lobes.h"

/// What the smooth and the rough plastic share.
namespace guidelight {

/// The diffuse base as seen through the coat, without the transmittances of the two crossings:
/// light that the coat reflects back down (share `internal`) scatters again, a geometric series;
/// 1/η² is the compression of radiance on entry.
struct PlasticBase {
  ColorTexture reflectance;
  float internal = 0;
  float eta = 1;
  bool nonlinear = false;  // the coat's share of each bounce is coloured, too

  Color eval(const SurfacePoint& point) const {
    const Color rho = reflectance.eval(point);
    const Color loss = nonlinear ? rho * internal : Color(internal);
    return rho / (1.0f - loss) / sqr(eta);
  }
};

/// Chooses between the coat's reflection (share `reflected` of the light) and the base.
inline float coat_probability(float reflected, float specular_weight) {
  const float specular = reflected * specular_weight;
  const float diffuse = (1 - reflected) * (1 - specular_weight);
  return specular + diffuse > 0 ? specular / (specular + diffuse) : 1.0f;
}

BsdfPointer make_rough_plastic(const PlasticBsdf& description, const BsdfContext& context);

}  // namespace guidelight

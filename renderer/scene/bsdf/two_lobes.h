#pragma once

#include "renderer/scene/bsdf/factories.h"

namespace guidelight {

/// Share of samples that the specular of two lobes deserves by its mean colour alone.
inline float specular_sampling_weight(const ColorTexture& diffuse, const ColorTexture& specular) {
  const float d = luminance(diffuse.mean());
  const float s = luminance(specular.mean());
  return d + s > 0 ? s / (d + s) : 1.0f;
}

/// Finishes a sample whose direction came from one of several finite lobes that cover each other:
/// its density and weight are those of all of them together.
inline std::optional<BsdfSample> sample_of_all_lobes(const Bsdf& bsdf, const SurfacePoint& point,
                                                     Vec3 wo, Vec3 wi, Lobe lobe) {
  const BsdfEvaluation drawn = bsdf.evaluate(point, wo, wi);
  if (!(drawn.pdf > 0)) return std::nullopt;
  return BsdfSample{wi, drawn.value / drawn.pdf, drawn.pdf, 1.0f, lobe};
}

}  // namespace guidelight

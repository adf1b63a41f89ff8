#pragma once

#include "renderer/scene/bsdf/two_lobes.h"

namespace guidelight {

/// Models that add one glossy lobe to a diffuse base, on the outside only. Derived classes give the
/// lobe's shape.
class LobeOverDiffuse : public Bsdf {
 public:
  LobeOverDiffuse(ColorTexture diffuse, ColorTexture specular);

  Color eval(const SurfacePoint& point, Vec3 wo, Vec3 wi) const final;
  float pdf(const SurfacePoint& point, Vec3 wo, Vec3 wi) const final;
  std::optional<BsdfSample> sample(const SurfacePoint& point, Vec3 wo, float u_lobe,
                                   Vec2 u) const final;
  int lobes() const final { return kLobeDiffuse | kLobeGlossy; }
  Color albedo(const SurfacePoint& point) const final;

 private:
  // Of the lobe alone; both directions are on the outside.
  /// f(wo, wi) for the specular reflectance 1 [1/sr].
  virtual float eval_lobe(const SurfacePoint& point, Vec3 wo, Vec3 wi) const = 0;
  virtual float pdf_lobe(const SurfacePoint& point, Vec3 wo, Vec3 wi) const = 0;
  /// May point inwards.
  virtual Vec3 sample_lobe(const SurfacePoint& point, Vec3 wo, Vec2 u) const = 0;

  float specular_probability_;
  float scale_;
  ColorTexture diffuse_;
  ColorTexture specular_;
};

}  // namespace guidelight

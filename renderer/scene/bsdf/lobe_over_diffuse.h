#pragma once

#include "renderer/scene/bsdf/two_lobes.h"

namespace guidelight {

/// Models that add one glossy lobe to a diffuse base, on the outside only. Derived classes give the
/// lobe's shape.
class LobeOverDiffuse : public Bsdf {
 public:
  LobeOverDiffuse(ColorTexture diffuse, ColorTexture specular);

  BsdfEvaluation evaluate(const SurfacePoint& point, Vec3 wo, Vec3 wi) const final;
  std::optional<BsdfSample> sample(const SurfacePoint& point, Vec3 wo, float u_lobe,
                                   Vec2 u) const final;
  int lobes() const final { return kLobeDiffuse | kLobeGlossy; }
  Color albedo(const SurfacePoint& point) const final;

 protected:
  /// The lobe between two directions, the same when they are swapped.
  struct SymmetricLobe {
    float f;    // for the specular reflectance 1 [1/sr]
    float pdf;  // of sample_lobe, per solid angle
  };

 private:
  // Of the lobe alone; both directions are on the outside.
  virtual SymmetricLobe evaluate_lobe(const SurfacePoint& point, Vec3 wo, Vec3 wi) const = 0;
  /// May point inwards.
  virtual Vec3 sample_lobe(const SurfacePoint& point, Vec3 wo, Vec2 u) const = 0;

  float specular_probability_;
  float scale_;
  ColorTexture diffuse_;
  ColorTexture specular_;
};

}  // namespace guidelight

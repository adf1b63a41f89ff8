#include "renderer/scene/surface_needs.h"

namespace guidelight {

namespace {

template <typename... Inputs>
SurfaceNeeds textured(const Inputs&... inputs) {
  return {((inputs.texture != kNone) || ...), false};
}

/// Roughness that differs by direction needs a tangent.
template <typename Model>
SurfaceNeeds anisotropic(const Model& model) {
  SurfaceNeeds needs = textured(model.alpha_u, model.alpha_v);
  needs.parametrisation |= model.alpha_u.value != model.alpha_v.value;
  return needs;
}

constexpr SurfaceNeeds kEverything{true, true};

struct NeedsOfModel {
  const SceneDescription& scene;

  SurfaceNeeds nested(int bsdf) const { return needs_of_bsdf(scene, bsdf); }

  SurfaceNeeds operator()(const DiffuseBsdf& m) const { return textured(m.reflectance); }
  SurfaceNeeds operator()(const RoughDiffuseBsdf& m) const {
    return textured(m.reflectance, m.alpha);
  }
  SurfaceNeeds operator()(const ConductorBsdf& m) const {
    return textured(m.specular_reflectance) |= anisotropic(m);
  }
  SurfaceNeeds operator()(const DielectricBsdf& m) const {
    return textured(m.specular_reflectance, m.specular_transmittance) |= anisotropic(m);
  }
  SurfaceNeeds operator()(const ThinDielectricBsdf& m) const {
    return textured(m.specular_reflectance, m.specular_transmittance);
  }
  SurfaceNeeds operator()(const PlasticBsdf& m) const {
    return textured(m.diffuse_reflectance, m.specular_reflectance, m.alpha);
  }
  SurfaceNeeds operator()(const PhongBsdf& m) const {
    return textured(m.diffuse_reflectance, m.specular_reflectance, m.exponent);
  }
  SurfaceNeeds operator()(const WardBsdf& m) const {
    return textured(m.diffuse_reflectance, m.specular_reflectance) |= anisotropic(m);
  }
  SurfaceNeeds operator()(const CoatingBsdf& m) const {
    return textured(m.sigma_a, m.specular_reflectance) |= nested(m.nested);
  }
  SurfaceNeeds operator()(const BlendBsdf& m) const {
    return (textured(m.weight) |= nested(m.first)) |= nested(m.second);
  }
  SurfaceNeeds operator()(const MaskBsdf& m) const {
    return textured(m.opacity) |= nested(m.nested);
  }
  SurfaceNeeds operator()(const TwoSidedBsdf& m) const { return nested(m.front) |= nested(m.back); }
  SurfaceNeeds operator()(const NullBsdf&) const { return {}; }
  SurfaceNeeds operator()(const NormalMapBsdf&) const { return kEverything; }
  SurfaceNeeds operator()(const BumpMapBsdf&) const { return kEverything; }
};

}  // namespace

SurfaceNeeds& SurfaceNeeds::operator|=(const SurfaceNeeds& other) {
  parametrisation |= other.parametrisation;
  perturbed_normal |= other.perturbed_normal;
  return *this;
}

SurfaceNeeds needs_of_bsdf(const SceneDescription& scene, int bsdf) {
  if (bsdf == kNone) return {};
  return std::visit(NeedsOfModel{scene}, scene.bsdfs.at(bsdf).model);
}

}  // namespace guidelight

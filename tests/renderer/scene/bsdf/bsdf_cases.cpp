#include "tests/renderer/scene/bsdf/bsdf_cases.h"

namespace guidelight::bsdf_test {
namespace {

constexpr Microfacet kGgx = Microfacet::Ggx;
constexpr Microfacet kBeckmann = Microfacet::Beckmann;

ConductorBsdf gold(float alpha_u, float alpha_v, Microfacet kind) {
  return {.eta = Color(0.18f, 0.42f, 1.37f),
          .k = Color(3.42f, 2.35f, 1.77f),
          .alpha_u = {alpha_u},
          .alpha_v = {alpha_v},
          .distribution = kind};
}

DielectricBsdf glass(float alpha_u, float alpha_v, Microfacet kind, float int_ior = 1.5f) {
  return {.int_ior = int_ior,
          .ext_ior = 1,
          .alpha_u = {alpha_u},
          .alpha_v = {alpha_v},
          .distribution = kind};
}

PlasticBsdf plastic(float alpha, Microfacet kind, bool nonlinear = false) {
  return {.int_ior = 1.5f,
          .ext_ior = 1,
          .diffuse_reflectance = {Color(0.7f, 0.5f, 0.2f)},
          .nonlinear = nonlinear,
          .alpha = {alpha},
          .distribution = kind};
}

}  // namespace

std::shared_ptr<const Bsdf> Case::build() const {
  SceneDescription scene;
  scene.bsdfs = bsdfs;
  return make_bsdfs(scene, {}).back();
}

std::vector<Case> all_cases() {
  const DiffuseBsdf red{.reflectance = {Color(0.8f, 0.3f, 0.1f)}};
  const PhongBsdf phong{.exponent = {25}};
  WardBsdf ward{.alpha_u = {0.15f}, .alpha_v = {0.3f}};
  std::vector<Case> cases = {
      {"diffuse", chain(red)},
      {"rough_diffuse", chain(RoughDiffuseBsdf{.alpha = {0.6f}})},
      {"conductor", chain(gold(0, 0, kGgx))},
      {"conductor_ggx_0_1", chain(gold(0.1f, 0.1f, kGgx))},
      {"conductor_ggx_anisotropic", chain(gold(0.1f, 0.5f, kGgx))},
      {"conductor_beckmann_0_1", chain(gold(0.1f, 0.1f, kBeckmann))},
      {"conductor_beckmann_anisotropic", chain(gold(0.6f, 0.15f, kBeckmann))},
      {"dielectric", chain(glass(0, 0, kGgx))},
      {"dielectric_ggx_0_1", chain(glass(0.1f, 0.1f, kGgx))},
      {"dielectric_ggx_anisotropic", chain(glass(0.2f, 0.5f, kGgx))},
      {"dielectric_beckmann_0_3", chain(glass(0.3f, 0.3f, kBeckmann))},
      {"dielectric_beckmann_bubble", chain(glass(0.2f, 0.2f, kBeckmann, 0.7f))},
      {"thin_dielectric", chain(ThinDielectricBsdf{.int_ior = 1.5f, .ext_ior = 1})},
      {"plastic", chain(plastic(0, kGgx))},
      {"plastic_nonlinear", chain(plastic(0, kGgx, true))},
      {"rough_plastic_ggx_0_1", chain(plastic(0.1f, kGgx))},
      {"rough_plastic_beckmann_0_3", chain(plastic(0.3f, kBeckmann, true))},
      {"phong", chain(phong)},
      {"coating_diffuse",
       chain(red, CoatingBsdf{.nested = 0, .sigma_a = {Color(0.1f, 0.2f, 0.3f)}})},
      {"coating_conductor", chain(gold(0, 0, kGgx), CoatingBsdf{.nested = 0})},
      {"coating_rough_conductor", chain(gold(0.2f, 0.2f, kGgx), CoatingBsdf{.nested = 0})},
      {"blend_finite", chain(red, phong, BlendBsdf{.weight = {0.3f}, .first = 0, .second = 1})},
      {"blend_delta", chain(glass(0, 0, kGgx), plastic(0, kGgx),
                            BlendBsdf{.weight = {0.6f}, .first = 0, .second = 1})},
      {"blend_refracting",
       chain(glass(0.2f, 0.2f, kGgx), red, BlendBsdf{.weight = {0.4f}, .first = 0, .second = 1})},
      {"mask_plastic", chain(plastic(0, kGgx), MaskBsdf{.opacity = {0.7f}, .nested = 0})},
      {"mask_rough_dielectric",
       chain(glass(0.3f, 0.3f, kGgx), MaskBsdf{.opacity = {0.7f}, .nested = 0})},
      {"mask_thin_dielectric", chain(ThinDielectricBsdf{.int_ior = 1.5f, .ext_ior = 1},
                                     MaskBsdf{.opacity = {0.7f}, .nested = 0})},
      {"twosided", chain(red, phong, TwoSidedBsdf{.front = 0, .back = 1})},
      {"twosided_mask", chain(plastic(0.2f, kGgx), TwoSidedBsdf{.front = 0, .back = 0},
                              MaskBsdf{.opacity = {0.4f}, .nested = 1})},
      {"null", chain(NullBsdf{})},
  };
  using Variant = WardBsdf::Variant;
  for (const auto& [name, variant] : {std::pair{"ward", Variant::Ward},
                                      {"ward_duer", Variant::WardDuer},
                                      {"ward_balanced", Variant::Balanced}}) {
    ward.variant = variant;
    cases.push_back({name, chain(ward)});
  }
  return cases;
}

}  // namespace guidelight::bsdf_test

#include "renderer/scene/bsdf/fresnel.h"
#include "renderer/scene/bsdf/lobe_over_diffuse.h"

namespace guidelight {
namespace {

/// Lafortune & Willems 1994, "Using the Modified Phong Reflectance Model for Physically Based
/// Rendering": a cosine power around the mirror direction.
class Phong final : public LobeOverDiffuse {
 public:
  Phong(ColorTexture diffuse, ColorTexture specular, FloatTexture exponent)
      : LobeOverDiffuse(std::move(diffuse), std::move(specular)), exponent_(std::move(exponent)) {}

 private:
  SymmetricLobe evaluate_lobe(const SurfacePoint& point, Vec3 wo, Vec3 wi) const override {
    const float n = exponent(point);
    const float power = 0.5f * kInvPi * cosine_power(wo, wi, n);
    return {(n + 2) * power, (n + 1) * power};
  }

  Vec3 sample_lobe(const SurfacePoint& point, Vec3 wo, Vec2 u) const override {
    const float cos_mirror = std::pow(1 - u.x, 1 / (exponent(point) + 1));
    const float sin_mirror = safe_sqrt(1 - cos_mirror * cos_mirror);
    const float phi = 2 * kPi * u.y;
    const Vec3 around(sin_mirror * std::cos(phi), sin_mirror * std::sin(phi), cos_mirror);
    return Frame::from_normal(reflect(wo)).to_world(around);
  }

  float exponent(const SurfacePoint& point) const { return std::max(exponent_.eval(point), 0.0f); }

  static float cosine_power(Vec3 wo, Vec3 wi, float n) {
    const float cos_mirror = glm::dot(reflect(wo), wi);
    return cos_mirror > 0 ? std::pow(cos_mirror, n) : 0.0f;
  }

  FloatTexture exponent_;
};

}  // namespace

BsdfPointer make_bsdf(const PhongBsdf& description, const BsdfContext& context) {
  return std::make_shared<Phong>(context.color(description.diffuse_reflectance),
                                 context.color(description.specular_reflectance),
                                 context.scalar(description.exponent));
}

}  // namespace guidelight

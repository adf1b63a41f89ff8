#include "renderer/sampling/warp.h"
#include "renderer/scene/bsdf/fresnel.h"
#include "renderer/scene/bsdf/two_lobes.h"

namespace guidelight {
namespace {

/// Lafortune & Willems 1994, "Using the Modified Phong Reflectance Model for Physically Based
/// Rendering": a cosine power around the mirror direction over a diffuse base, on the outside only.
class Phong final : public Bsdf {
 public:
  Phong(ColorTexture diffuse, ColorTexture specular, FloatTexture exponent, float scale)
      : specular_probability_(specular_sampling_weight(diffuse, specular)),
        diffuse_(std::move(diffuse)),
        specular_(std::move(specular)),
        exponent_(std::move(exponent)),
        scale_(scale) {}

  Color eval(const SurfacePoint& point, Vec3 wo, Vec3 wi) const override {
    if (wo.z <= 0 || wi.z <= 0) return Color(0.0f);
    Color f = diffuse_.eval(point) * kInvPi;
    const float cos_mirror = glm::dot(reflect(wo), wi);
    if (cos_mirror > 0) {
      const float n = exponent(point);
      f += specular_.eval(point) * ((n + 2) * 0.5f * kInvPi * std::pow(cos_mirror, n));
    }
    return f * (scale_ * wi.z);
  }

  float pdf(const SurfacePoint& point, Vec3 wo, Vec3 wi) const override {
    if (wo.z <= 0 || wi.z <= 0) return 0;
    const float cos_mirror = glm::dot(reflect(wo), wi);
    const float n = exponent(point);
    const float specular =
        cos_mirror > 0 ? (n + 1) * 0.5f * kInvPi * std::pow(cos_mirror, n) : 0.0f;
    return glm::mix(cosine_hemisphere_pdf(wi.z), specular, specular_probability_);
  }

  std::optional<BsdfSample> sample(const SurfacePoint& point, Vec3 wo, float u_lobe,
                                   Vec2 u) const override {
    if (wo.z <= 0) return std::nullopt;
    const bool is_specular = u_lobe < specular_probability_;
    const Vec3 wi =
        is_specular ? sample_around_mirror(wo, exponent(point), u) : square_to_cosine_hemisphere(u);
    return sample_of_all_lobes(*this, point, wo, wi, is_specular ? kLobeGlossy : kLobeDiffuse);
  }

  int lobes() const override { return kLobeDiffuse | kLobeGlossy; }
  Color albedo(const SurfacePoint& point) const override {
    return scale_ * (diffuse_.eval(point) + specular_.eval(point));
  }

 private:
  float exponent(const SurfacePoint& point) const { return std::max(exponent_.eval(point), 0.0f); }

  static Vec3 sample_around_mirror(Vec3 wo, float n, Vec2 u) {
    const float cos_mirror = std::pow(1 - u.x, 1 / (n + 1));
    const float sin_mirror = safe_sqrt(1 - cos_mirror * cos_mirror);
    const float phi = 2 * kPi * u.y;
    const Vec3 around(sin_mirror * std::cos(phi), sin_mirror * std::sin(phi), cos_mirror);
    return Frame::from_normal(reflect(wo)).to_world(around);
  }

  float specular_probability_;
  ColorTexture diffuse_;
  ColorTexture specular_;
  FloatTexture exponent_;
  float scale_;
};

}  // namespace

BsdfPointer make_bsdf(const PhongBsdf& description, const BsdfContext& context) {
  ColorTexture diffuse = context.color(description.diffuse_reflectance);
  ColorTexture specular = context.color(description.specular_reflectance);
  const float scale = energy_scale(diffuse, specular);
  return std::make_shared<Phong>(std::move(diffuse), std::move(specular),
                                 context.scalar(description.exponent), scale);
}

}  // namespace guidelight

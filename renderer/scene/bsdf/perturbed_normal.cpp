#include "renderer/scene/bsdf/factories.h"

namespace guidelight {
namespace {

/// A BSDF whose shading frame another one replaces; it scatters in that frame as the nested BSDF
/// does.
class PerturbedNormal : public Bsdf {
 public:
  explicit PerturbedNormal(BsdfPointer nested) : nested_(std::move(nested)) {}

  BsdfEvaluation evaluate(const SurfacePoint& point, Vec3 wo, Vec3 wi) const override {
    return nested_->evaluate(point, wo, wi);
  }
  std::optional<BsdfSample> sample(const SurfacePoint& point, Vec3 wo, float u_lobe,
                                   Vec2 u) const override {
    return nested_->sample(point, wo, u_lobe, u);
  }
  std::optional<SpecularEvent> specular(const SurfacePoint& point, Vec3 wo,
                                        Lobe lobe) const override {
    return nested_->specular(point, wo, lobe);
  }
  int lobes() const override { return nested_->lobes(); }
  float eta() const override { return nested_->eta(); }
  Color albedo(const SurfacePoint& point) const override { return nested_->albedo(point); }

  Frame shading_frame(const SurfacePoint& point) const override {
    SurfacePoint perturbed = point;
    perturbed.frame = perturb(point);
    return nested_->shading_frame(perturbed);
  }

 protected:
  virtual Frame perturb(const SurfacePoint& point) const = 0;

 private:
  BsdfPointer nested_;
};

class NormalMap final : public PerturbedNormal {
 public:
  NormalMap(std::shared_ptr<const Texture> texture, bool y_is_against_v, BsdfPointer nested)
      : PerturbedNormal(std::move(nested)),
        texture_(std::move(texture)),
        y_is_against_v_(y_is_against_v) {}

 private:
  Frame perturb(const SurfacePoint& point) const override {
    Vec3 local = 2.0f * texture_->eval(point) - 1.0f;
    const float squared = length_squared(local);
    if (!(squared > 1e-6f)) return point.frame;
    if (y_is_against_v_ && glm::dot(point.frame.t, point.dpdv) > 0) local.y = -local.y;
    return Frame::from_normal_and_tangent(point.frame.to_world(local / std::sqrt(squared)),
                                          point.dpdu);
  }

  std::shared_ptr<const Texture> texture_;
  bool y_is_against_v_;
};

class BumpMap final : public PerturbedNormal {
 public:
  BumpMap(std::shared_ptr<const Texture> texture, float scale, BsdfPointer nested)
      : PerturbedNormal(std::move(nested)), texture_(std::move(texture)), scale_(scale) {}

 private:
  Frame perturb(const SurfacePoint& point) const override {
    const Vec3 n = point.frame.n;
    const Vec3 dpdu = displaced_derivative(n, point.dpdu, slope(point, Vec2(1, 0)));
    const Vec3 dpdv = displaced_derivative(n, point.dpdv, slope(point, Vec2(0, 1)));
    Vec3 normal = glm::cross(dpdu, dpdv);
    const float squared = length_squared(normal);
    if (!(squared > 0) || !std::isfinite(squared)) return point.frame;
    normal /= std::sqrt(squared);
    if (glm::dot(normal, n) < 0) normal = -normal;
    return Frame::from_normal_and_tangent(normal, dpdu);
  }

  /// Blinn 1978, "Simulation of Wrinkled Surfaces", with the derivative first brought into the
  /// plane of the shading normal.
  static Vec3 displaced_derivative(Vec3 n, Vec3 derivative, float height_slope) {
    return derivative + n * (height_slope - glm::dot(n, derivative));
  }

  /// Height per unit of uv along an axis, by central difference over less than a texel of a 1k
  /// image.
  float slope(SurfacePoint point, Vec2 axis) const {
    constexpr float kStep = 0x1p-11f;
    const Vec2 uv = point.uv;
    point.uv = uv + kStep * axis;
    const float after = luminance(texture_->eval(point));
    point.uv = uv - kStep * axis;
    return scale_ * (after - luminance(texture_->eval(point))) / (2 * kStep);
  }

  std::shared_ptr<const Texture> texture_;
  float scale_;
};

}  // namespace

BsdfPointer make_bsdf(const NormalMapBsdf& description, const BsdfContext& context) {
  return std::make_shared<NormalMap>(context.texture(description.texture),
                                     description.y_is_against_v,
                                     context.nested(description.nested));
}

BsdfPointer make_bsdf(const BumpMapBsdf& description, const BsdfContext& context) {
  return std::make_shared<BumpMap>(context.texture(description.texture), description.scale,
                                   context.nested(description.nested));
}

}  // namespace guidelight

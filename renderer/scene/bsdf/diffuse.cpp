#include "renderer/sampling/warp.h"
#include "renderer/scene/bsdf/factories.h"

namespace guidelight {
namespace {

/// Lambert's ideal diffuse reflection, on the outside only.
class Diffuse final : public Bsdf {
 public:
  explicit Diffuse(ColorTexture reflectance) : reflectance_(std::move(reflectance)) {}

  BsdfEvaluation evaluate(const SurfacePoint& point, Vec3 wo, Vec3 wi) const override {
    if (wo.z <= 0 || wi.z <= 0) return {};
    const float pdf = wi.z * kInvPi;
    return {reflectance_.eval(point) * pdf, pdf, wo.z * kInvPi};
  }

  std::optional<BsdfSample> sample(const SurfacePoint& point, Vec3 wo, float,
                                   Vec2 u) const override {
    if (wo.z <= 0) return std::nullopt;
    const Vec3 wi = square_to_cosine_hemisphere(u);
    if (wi.z <= 0) return std::nullopt;
    return BsdfSample{wi, reflectance_.eval(point), wi.z * kInvPi, 1.0f, kLobeDiffuse};
  }

  int lobes() const override { return kLobeDiffuse; }
  Color albedo(const SurfacePoint& point) const override { return reflectance_.eval(point); }

 private:
  ColorTexture reflectance_;
};

}  // namespace

BsdfPointer make_bsdf(const DiffuseBsdf& description, const BsdfContext& context) {
  return std::make_shared<Diffuse>(context.color(description.reflectance));
}

}  // namespace guidelight

#include "renderer/scene/bsdf/factories.h"

namespace guidelight {
namespace {

/// Everything passes straight through.
class Null final : public Bsdf {
 public:
  BsdfEvaluation evaluate(const SurfacePoint&, Vec3, Vec3) const override { return {}; }

  std::optional<BsdfSample> sample(const SurfacePoint&, Vec3 wo, float, Vec2) const override {
    return BsdfSample{-wo, Color(1.0f), 1.0f, 1.0f, kLobeDeltaTransmission};
  }

  std::optional<SpecularEvent> specular(const SurfacePoint&, Vec3 wo, Lobe lobe) const override {
    if (lobe != kLobeDeltaTransmission) return std::nullopt;
    return SpecularEvent{-wo, Color(1.0f), 1.0f};
  }

  int lobes() const override { return kLobeDeltaTransmission; }
  Color albedo(const SurfacePoint&) const override { return Color(1.0f); }
};

}  // namespace

BsdfPointer make_bsdf(const NullBsdf&, const BsdfContext&) { return std::make_shared<Null>(); }

}  // namespace guidelight

#include "renderer/scene/bsdf/factories.h"

namespace guidelight {
namespace {

/// Light that meets the back scatters as `back` would scatter it at its front.
class TwoSided final : public Bsdf {
 public:
  TwoSided(BsdfPointer front, BsdfPointer back)
      : front_(std::move(front)), back_(std::move(back)) {}

  BsdfEvaluation evaluate(const SurfacePoint& point, Vec3 wo, Vec3 wi) const override {
    return side(wo).evaluate(point, up(wo, wo), up(wi, wo));
  }

  std::optional<BsdfSample> sample(const SurfacePoint& point, Vec3 wo, float u_lobe,
                                   Vec2 u) const override {
    std::optional<BsdfSample> drawn = side(wo).sample(point, up(wo, wo), u_lobe, u);
    if (drawn) drawn->wi = up(drawn->wi, wo);
    return drawn;
  }

  std::optional<SpecularEvent> specular(const SurfacePoint& point, Vec3 wo,
                                        Lobe lobe) const override {
    std::optional<SpecularEvent> event = side(wo).specular(point, up(wo, wo), lobe);
    if (event) event->wi = up(event->wi, wo);
    return event;
  }

  int lobes() const override { return front_->lobes() | back_->lobes(); }
  Color albedo(const SurfacePoint& point) const override { return front_->albedo(point); }
  /// One frame serves both sides: the front's.
  Frame shading_frame(const SurfacePoint& point) const override {
    return front_->shading_frame(point);
  }

 private:
  const Bsdf& side(Vec3 wo) const { return wo.z >= 0 ? *front_ : *back_; }
  /// Mirrors w to the front if wo is at the back.
  static Vec3 up(Vec3 w, Vec3 wo) { return {w.x, w.y, wo.z >= 0 ? w.z : -w.z}; }

  BsdfPointer front_;
  BsdfPointer back_;
};

}  // namespace

BsdfPointer make_bsdf(const TwoSidedBsdf& description, const BsdfContext& context) {
  BsdfPointer front = context.nested(description.front);
  // An interface that refracts has two sides already, and they differ.
  if (front->eta() != 1) return front;
  return std::make_shared<TwoSided>(std::move(front), context.nested(description.back));
}

}  // namespace guidelight

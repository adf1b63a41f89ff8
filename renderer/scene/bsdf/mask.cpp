#include <algorithm>

#include "renderer/scene/bsdf/factories.h"

namespace guidelight {
namespace {

/// A surface with holes too small to see. Where the nested BSDF refracts in another direction than
/// straight on, specular() reports the likelier of the two.
class Mask final : public Bsdf {
 public:
  Mask(FloatTexture opacity, BsdfPointer nested)
      : opacity_(std::move(opacity)),
        nested_(std::move(nested)),
        nested_passes_(nested_->lobes() & kLobeDeltaTransmission) {}

  BsdfEvaluation evaluate(const SurfacePoint& point, Vec3 wo, Vec3 wi) const override {
    const BsdfEvaluation nested = nested_->evaluate(point, wo, wi);
    const float covered = opacity(point);
    return {covered * nested.value, covered * nested.pdf, covered * nested.pdf_reverse};
  }

  std::optional<BsdfSample> sample(const SurfacePoint& point, Vec3 wo, float u_lobe,
                                   Vec2 u) const override {
    const float covered = opacity(point);
    std::optional<BsdfSample> drawn;
    if (u_lobe >= covered) {
      drawn = BsdfSample{-wo, Color(1.0f), 1 - covered, 1.0f, kLobeDeltaTransmission};
    } else {
      drawn = nested_->sample(point, wo, reuse_below(u_lobe, covered), u);
      if (drawn) drawn->pdf *= covered;
    }
    // Straight on there may be two ways.
    if (nested_passes_ && drawn && drawn->lobe == kLobeDeltaTransmission) {
      const std::optional<SpecularEvent> event = specular(point, wo, drawn->lobe);
      if (event && is_same_event(event->wi, drawn->wi)) {
        drawn->pdf = event->probability;
        drawn->weight = event->value / event->probability;
      }
    }
    return drawn;
  }

  std::optional<SpecularEvent> specular(const SurfacePoint& point, Vec3 wo,
                                        Lobe lobe) const override {
    const float covered = opacity(point);
    std::optional<SpecularEvent> event = nested_->specular(point, wo, lobe);
    if (event) {
      event->value *= covered;
      event->probability *= covered;
    }
    const float open = 1 - covered;
    if (lobe == kLobeDeltaTransmission) {
      if (event && is_same_event(event->wi, -wo)) {
        event->value += open;
        event->probability += open;
      } else if (open > (event ? event->probability : 0.0f)) {
        return SpecularEvent{-wo, Color(open), open};
      }
    }
    return event && event->probability > 0 ? event : std::nullopt;
  }

  int lobes() const override { return nested_->lobes() | kLobeDeltaTransmission; }
  float eta() const override { return nested_->eta(); }
  Color albedo(const SurfacePoint& point) const override {
    const float covered = opacity(point);
    return Color(1 - covered) + covered * nested_->albedo(point);
  }
  Frame shading_frame(const SurfacePoint& point) const override {
    return nested_->shading_frame(point);
  }

 private:
  float opacity(const SurfacePoint& point) const {
    return std::clamp(opacity_.eval(point), 0.0f, 1.0f);
  }

  FloatTexture opacity_;
  BsdfPointer nested_;
  bool nested_passes_;
};

}  // namespace

BsdfPointer make_bsdf(const MaskBsdf& description, const BsdfContext& context) {
  return std::make_shared<Mask>(context.scalar(description.opacity),
                                context.nested(description.nested));
}

}  // namespace guidelight

#include <algorithm>

#include "renderer/scene/bsdf/factories.h"

namespace guidelight {
namespace {

/// Weighted sum of two BSDFs, chosen between by the weight. Two mirrors are one event; where the
/// two have delta transmissions in different directions, specular() reports the likelier.
class Blend final : public Bsdf {
 public:
  Blend(FloatTexture weight, BsdfPointer first, BsdfPointer second)
      : weight_(std::move(weight)), first_(std::move(first)), second_(std::move(second)) {}

  BsdfEvaluation evaluate(const SurfacePoint& point, Vec3 wo, Vec3 wi) const override {
    const BsdfEvaluation a = first_->evaluate(point, wo, wi);
    const BsdfEvaluation b = second_->evaluate(point, wo, wi);
    const float share = weight(point);
    return {glm::mix(a.value, b.value, share), glm::mix(a.pdf, b.pdf, share),
            glm::mix(a.pdf_reverse, b.pdf_reverse, share)};
  }

  std::optional<BsdfSample> sample(const SurfacePoint& point, Vec3 wo, float u_lobe,
                                   Vec2 u) const override {
    const float p_second = weight(point);
    const bool is_second = u_lobe < p_second;
    std::optional<BsdfSample> drawn =
        is_second ? second_->sample(point, wo, reuse_below(u_lobe, p_second), u)
                  : first_->sample(point, wo, reuse_above(u_lobe, p_second), u);
    if (!drawn) return std::nullopt;
    if (!drawn->is_delta()) {
      const BsdfEvaluation both = evaluate(point, wo, drawn->wi);
      if (!(both.pdf > 0)) return std::nullopt;
      drawn->pdf = both.pdf;
      drawn->weight = both.value / both.pdf;
      return drawn;
    }
    const std::optional<SpecularEvent> event = specular(point, wo, drawn->lobe);
    if (event && is_same_event(event->wi, drawn->wi)) {
      drawn->pdf = event->probability;
      drawn->weight = event->value / event->probability;
    } else {
      drawn->pdf *= is_second ? p_second : 1 - p_second;
    }
    return drawn;
  }

  std::optional<SpecularEvent> specular(const SurfacePoint& point, Vec3 wo,
                                        Lobe lobe) const override {
    const float p_second = weight(point);
    std::optional<SpecularEvent> a = share(first_->specular(point, wo, lobe), 1 - p_second);
    std::optional<SpecularEvent> b = share(second_->specular(point, wo, lobe), p_second);
    if (!a || !b) return a ? a : b;
    if (!is_same_event(a->wi, b->wi)) return a->probability >= b->probability ? a : b;
    a->value += b->value;
    a->probability += b->probability;
    return a;
  }

  int lobes() const override { return first_->lobes() | second_->lobes(); }
  float eta() const override { return first_->eta() != 1 ? first_->eta() : second_->eta(); }
  Color albedo(const SurfacePoint& point) const override {
    return glm::mix(first_->albedo(point), second_->albedo(point), weight(point));
  }
  /// One frame serves both: the first's, or the second's if the first leaves it as it is.
  Frame shading_frame(const SurfacePoint& point) const override {
    const Frame frame = first_->shading_frame(point);
    return frame.n == point.frame.n ? second_->shading_frame(point) : frame;
  }

 private:
  float weight(const SurfacePoint& point) const {
    return std::clamp(weight_.eval(point), 0.0f, 1.0f);
  }

  static std::optional<SpecularEvent> share(std::optional<SpecularEvent> event, float weight) {
    if (!event || weight == 0) return std::nullopt;
    event->value *= weight;
    event->probability *= weight;
    return event;
  }

  FloatTexture weight_;
  BsdfPointer first_;
  BsdfPointer second_;
};

}  // namespace

BsdfPointer make_bsdf(const BlendBsdf& description, const BsdfContext& context) {
  BsdfPointer first = context.nested(description.first);
  BsdfPointer second = context.nested(description.second);
  if (first->eta() != 1 && second->eta() != 1 && first->eta() != second->eta()) {
    throw Error("{}: a blend of two dielectrics needs one interior; give both the same IOR.",
                context.where);
  }
  return std::make_shared<Blend>(context.scalar(description.weight), std::move(first),
                                 std::move(second));
}

}  // namespace guidelight

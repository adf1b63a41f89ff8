#pragma once

#include "renderer/scene/bsdf/bsdf.h"

namespace guidelight {

/// What is transported along the path that is being built: a camera path carries importance
/// outwards and gathers Radiance; a light path carries radiance outwards and gathers Importance.
enum class TransportMode { Radiance, Importance };

/// A world-space direction drawn at a surface.
struct ScatteringSample {
  Vec3 wi;       // unit, world, away from the surface
  Color weight;  // value/pdf with all corrections
  float pdf;     // per solid angle; discrete probability for delta lobes
  float
      eta;  // IOR ratio crossed, 1 for reflection; its square is the RR-neutral factor of `weight`
  Lobe lobe;

  bool is_delta() const { return lobe & kLobeDelta; }
};

/// A BSDF at one surface point seen along wo, in world space: the only place where the two
/// corrections that make fs non-symmetric are applied (Veach 1997, chapter 5).
///  - refraction: radiance scales by (η_wo/η_wi)² across an interface (5.14), importance does not;
///  - shading normals: the adjoint BSDF is f·|wo·ns||wi·ng| / (|wo·ng||wi·ns|) (5.19).
/// `value` always means f·cosine as the transport mode needs it: |wi·ns| for radiance and
/// |wo·ns||wi·ng|/|wo·ng| for importance, so that throughput · value · value / d² is a connection.
/// A direction that lies on different sides of the geometric and the shading surface leaks: nothing
/// scatters from or to it, in either mode. Straight passes (null, mask) know no normal and never
/// leak.
class Scattering {
 public:
  /// wo: unit, world, towards where the path came from.
  Scattering(const SurfacePoint& point, Vec3 wo, TransportMode mode)
      : point_(&point),
        wo_(wo),
        wo_local_(point.frame.to_local(wo)),
        wo_cos_geometric_(glm::dot(wo, point.geometric_normal)),
        mode_(mode) {}

  /// Value and both densities for wi, unit, world; finite lobes only.
  BsdfEvaluation evaluate(Vec3 wi) const {
    const Vec3 wi_local = point_->frame.to_local(wi);
    if (leaks(wi, wi_local)) return {};
    BsdfEvaluation result = point_->bsdf->evaluate(*point_, wo_local_, wi_local);
    result.value *= correction(wi, wi_local, eta_towards(wi_local));
    return result;
  }

  /// |wo·ns|/|wo·ng|: how much more light the shading surface takes from wo than meets the true
  /// one. The part of (5.19) that belongs to wo; 0 where wo leaks.
  float shading_gain() const {
    return wo_local_.z * wo_cos_geometric_ > 0 ? wo_local_.z / wo_cos_geometric_ : 0.0f;
  }
  /// |wi·ns|, the cosine in the `value` of radiance.
  float shading_cosine(Vec3 wi) const { return std::abs(glm::dot(wi, point_->frame.n)); }

  // One of the three alone.
  Color value(Vec3 wi) const { return evaluate(wi).value; }
  float pdf(Vec3 wi) const { return evaluate(wi).pdf; }
  float pdf_reverse(Vec3 wi) const { return evaluate(wi).pdf_reverse; }

  std::optional<ScatteringSample> sample(float u_lobe, Vec2 u) const {
    const std::optional<BsdfSample> drawn = point_->bsdf->sample(*point_, wo_local_, u_lobe, u);
    return drawn ? to_world(*drawn) : std::nullopt;
  }

  /// The delta event of one kind; empty if there is none.
  std::optional<ScatteringSample> specular(Lobe lobe) const {
    const std::optional<SpecularEvent> event = point_->bsdf->specular(*point_, wo_local_, lobe);
    if (!event || !(event->probability > 0)) return std::nullopt;
    return to_world(
        {event->wi, event->value / event->probability, event->probability, event->eta, lobe});
  }

  /// True if connections can be made here: some lobe is finite.
  bool is_connectible() const { return point_->bsdf->lobes() & kLobeSmooth; }

 private:
  std::optional<ScatteringSample> to_world(const BsdfSample& drawn) const {
    if (drawn.eta == 1 && drawn.wi == -wo_local_) {
      return ScatteringSample{-wo_, drawn.weight, drawn.pdf, 1.0f, drawn.lobe};
    }
    const Vec3 wi = point_->frame.to_world(drawn.wi);
    if (leaks(wi, drawn.wi)) return std::nullopt;
    return ScatteringSample{wi, drawn.weight * correction(wi, drawn.wi, drawn.eta), drawn.pdf,
                            drawn.eta, drawn.lobe};
  }

  bool leaks(Vec3 wi, Vec3 wi_local) const {
    return glm::dot(wi, point_->geometric_normal) * wi_local.z <= 0 ||
           wo_cos_geometric_ * wo_local_.z <= 0;
  }

  /// IOR on the side of wi over IOR on the side of wo.
  float eta_towards(Vec3 wi_local) const {
    if (same_hemisphere(wo_local_, wi_local)) return 1;
    const float eta = point_->bsdf->eta();
    return wo_local_.z > 0 ? eta : 1 / eta;
  }

  /// Factor that turns the flux form of the BSDF into what the transport mode needs; wi does not
  /// leak.
  float correction(Vec3 wi, Vec3 wi_local, float eta) const {
    if (mode_ == TransportMode::Radiance) return 1 / (eta * eta);
    return std::abs(wo_local_.z * glm::dot(wi, point_->geometric_normal) /
                    (wo_cos_geometric_ * wi_local.z));
  }

  const SurfacePoint* point_;
  Vec3 wo_;
  Vec3 wo_local_;
  float wo_cos_geometric_;
  TransportMode mode_;
};

}  // namespace guidelight

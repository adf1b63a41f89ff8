#pragma once

#include "renderer/scene/bsdf/bsdf.h"

namespace guidelight {

/// What is transported along the path that is being built: a camera path carries importance outwards and
/// gathers Radiance; a light path carries radiance outwards and gathers Importance.
enum class TransportMode { Radiance, Importance };

/// A world-space direction drawn at a surface.
struct ScatteringSample {
  Vec3 wi;         // unit, world, away from the surface
  Color weight;    // value/pdf with all corrections
  float pdf;       // per solid angle; discrete probability for delta lobes
  float eta;       // IOR ratio crossed, 1 for reflection; its square is the RR-neutral factor of `weight`
  Lobe lobe;

  bool is_delta() const { return lobe & kLobeDelta; }
};

/// A BSDF at one surface point seen along wo, in world space: the only place where the two corrections
/// that make fs non-symmetric are applied (Veach 1997, chapter 5).
///  - refraction: radiance scales by (η_wo/η_wi)² across an interface (5.14), importance does not;
///  - shading normals: the adjoint BSDF is f·|wo·ns||wi·ng| / (|wo·ng||wi·ns|) (5.19).
/// `value` always means f·cosine as the transport mode needs it: |wi·ns| for radiance and
/// |wo·ns||wi·ng|/|wo·ng| for importance, so that throughput · value · value / d² is a connection.
class Scattering {
 public:
  /// wo: unit, world, towards where the path came from.
  Scattering(const SurfacePoint& point, Vec3 wo, TransportMode mode);

  Color value(Vec3 wi) const;
  /// Density of drawing wi from here, per solid angle, finite lobes only.
  float pdf(Vec3 wi) const;
  /// Density of drawing wo if the path came from wi, per solid angle, finite lobes only.
  float pdf_reverse(Vec3 wi) const;
  std::optional<ScatteringSample> sample(float u_lobe, Vec2 u) const;

  /// True if connections can be made here: some lobe is finite.
  bool is_connectible() const { return point_->bsdf->lobes() & kLobeSmooth; }

 private:
  /// Zero if wi leaks: on different sides of the geometric and the shading surface.
  float correction(Vec3 wi, Vec3 wi_local, float eta) const;

  const SurfacePoint* point_;
  Vec3 wo_;
  Vec3 wo_local_;
  float wo_cos_geometric_;
  TransportMode mode_;
};

}  // namespace guidelight

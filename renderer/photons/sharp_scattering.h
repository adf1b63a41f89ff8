#pragma once

#include "renderer/scene/bsdf/scattering.h"
#include "renderer/transport/path_vertex.h"
#include "renderer/transport/subpath.h"

namespace guidelight {

/// Which scattering photon mapping follows like a mirror's and which it estimates from photons. It
/// divides events, not materials: an event is *sharp* if its lobe is a delta or if its density, in
/// either direction and times the probability of survival, is above a bound; all others are
/// *diffuse*. Light and camera agree about every event, so that each path is counted once, also on
/// materials that mix a diffuse and a glossy lobe.
class SharpScattering {
 public:
  /// `bound` per solid angle. A diffuse lobe has at most 1/π.
  explicit SharpScattering(float bound) : bound_(std::max(bound, kInvPi)) {}

  /// Whether a material can scatter sharply at all.
  static bool is_possible(const Bsdf& bsdf) { return bsdf.lobes() & ~kLobeDiffuse; }

  bool operator()(const PathVertex& vertex, const Scattering& scattering, Vec3 wi) const {
    if (!(vertex.point.bsdf->lobes() & kLobeGlossy)) return false;
    const BsdfEvaluation bsdf = scattering.evaluate(wi);
    return is_above(std::max(bsdf.pdf, bsdf.pdf_reverse) * vertex.survival);
  }
  /// The larger density of a finite event of a glossy lobe, survival included [1/sr].
  bool is_above(float pdf) const { return pdf > bound_; }

  /// The event at the origin of a path's current segment, where that is a vertex.
  bool at_origin(const Subpath& path) const {
    return !path.is_connectible || is_above(std::max(path.pdf, path.pdf_backward));
  }

 private:
  float bound_;
};

}  // namespace guidelight

#pragma once

#include "renderer/integrators/photon_mapping/importance.h"

namespace guidelight {

/// Power of photons that chains and light paths leave in one map. Either way to make a photon has a
/// density; its power is the light that arrives, divided by the sum of both:
///   Φ = f_map / ( N/B · Y(f_map ⊙ I) + M · p )
/// of N states of chains and M light paths of density p. That is the balance heuristic (Veach 1997,
/// 9.2.2.1) between two estimates of the same map. Where I is estimated too low (narrow lobes,
/// light that few look at) the first term alone would be the reciprocal of nearly nothing; so no
/// photon is stronger than that of a light path. Where nothing is known of I, light paths alone
/// leave photons.
class PhotonPower {
 public:
  /// `scale` is B/N.
  PhotonPower(const ImportanceMaps& importance, double scale, int light_paths)
      : importance_(importance), scale_(scale), light_paths_(light_paths) {}

  /// I at a light vertex.
  Color importance(const PathVertex& vertex, const Scattering& scattering,
                   bool for_caustic_map) const {
    return for_caustic_map ? importance_.of_caustic(vertex, scattering)
                           : importance_.of_global(vertex, scattering);
  }

  /// Of a state of weight 1. `pdf` is the density of a light path that leaves the same photon, in
  /// the measure of `f`.
  Color of_state(const glm::dvec3& f, double pdf, Color importance) const;
  /// Of a light path's vertex with this throughput: f over its density.
  Color of_light_path(Color carried, Color importance) const;

 private:
  /// N/B · Y(f ⊙ I)
  double chain_density(Color f, Color importance) const {
    return luminance(f * importance) / scale_;
  }

  const ImportanceMaps& importance_;
  double scale_;
  int light_paths_;
};

}  // namespace guidelight

#pragma once

#include <unordered_map>

#include "renderer/integrators/photon_mapping/photon_power.h"
#include "renderer/integrators/photon_mapping/second_pass.h"
#include "renderer/transport/path.h"

namespace guidelight {

/// Where a complete path leaves its photon (Fan et al. 2005, section 4.2).
struct PhotonSite {
  int vertex;    // index on the path
  bool caustic;  // for the caustic map
};

/// Global photons at the second diffuse event counted from the eye, sharp ones between allowed; a
/// caustic photon at the first of L S⁺ D S* E; none for other paths.
std::optional<PhotonSite> photon_site(const Path& path, const SharpScattering& sharp);

/// Turns the states of a chain, whose target is the luminance of complete paths, into photons.
/// Their power divides by the *marginal* density of the light's side, Y(f_map ⊙ I)/B, and not by
/// that of the complete path, which is the density of more than the photon is: see
/// docs/metropolis.md. States that leave their photons in the same place, or nearly, add up to one:
/// a chain goes by small steps, and photons in one point would be an endless density to an estimate
/// from the nearest.
class PhotonObserver {
 public:
  PhotonObserver(const PhotonMappingPass& setup, const PhotonPower& power, Rng rng)
      : setup_(setup), power_(power), rng_(rng) {}

  void operator()(const Path& path, double weight);
  PassPhotons photons() const;

 private:
  /// A small cell of a surface, and what all states with their photon there have left. Of their
  /// places and directions it keeps one, drawn in proportion to power.
  struct Deposit {
    PathVertex vertex;
    bool caustic;
    Color importance;  // of light that arrives as `vertex` says
    Color power{0};    // sum over states
  };

  /// Hash of the cell that a photon falls into.
  uint64_t cell(const PathVertex& vertex, bool caustic) const;
  /// Power of a state of weight 1.
  Color state_power(const Path& path, const PhotonSite& site, Color importance) const;
  Color importance_at(const PathVertex& vertex, bool caustic) const;
  PathVertex vertex_at(const Path& path, int i) const;

  const PhotonMappingPass& setup_;
  const PhotonPower& power_;
  Rng rng_;
  std::vector<Deposit> deposits_;
  std::unordered_map<uint64_t, uint32_t> places_;  // hash of a cell to its deposit
};

}  // namespace guidelight

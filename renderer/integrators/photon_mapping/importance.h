#pragma once

#include <vector>

#include "renderer/integrators/photon_mapping/settings.h"
#include "renderer/transport/random_walk.h"

namespace guidelight {

/// How much the eye sees of light that arrives at a place: importance, as particles from the lens
/// ("importons") leave it. I(y, ω) of docs/metropolis.md, estimated like the radiance of photons
/// with the roles of light and eye exchanged: it converges as the particles become more.
class ImportanceMaps {
 public:
  struct Settings {
    size_t paths;  // from the lens
    int neighbors;
  };

  ImportanceMaps(const PhotonMappingPass& setup, const Settings& settings, Parallel& parallel);

  /// What all eye paths whose second diffuse event is at a light vertex make of a unit of light
  /// that arrives there; 0 where nothing is known. The reciprocal is what is unbiased, where
  /// importance is even.
  Color of_global(const PathVertex& vertex, const Scattering& scattering) const;
  /// The same for the first diffuse event: seen directly, which is known exactly for a pinhole, and
  /// by sharp scattering.
  Color of_caustic(const PathVertex& vertex, const Scattering& scattering) const;

 private:
  Color estimate(const PhotonMap& map, const PathVertex& vertex,
                 const Scattering& scattering) const;
  Color seen_directly(const PathVertex& vertex, const Scattering& scattering) const;

  const Scene& scene_;
  EstimateSettings estimate_;
  PhotonMap global_;
  PhotonMap caustic_;
};

}  // namespace guidelight

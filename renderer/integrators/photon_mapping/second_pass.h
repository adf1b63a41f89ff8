#pragma once

#include <span>
#include <vector>

#include "renderer/integrators/photon_mapping/settings.h"

namespace guidelight {

/// Photons of one pass, however they were made. Their powers are those of whole maps.
struct PassPhotons {
  std::vector<SurfacePhoton> global;   // L (S|D)* D
  std::vector<SurfacePhoton> caustic;  // L S+ D
};

/// The photons of all parts, in order.
PassPhotons join(std::span<const PassPhotons> parts);

/// The second of the two passes: builds the maps and renders one picture from them into the film.
void show_photons(const PhotonMappingPass& setup, const PassPhotons& photons, Film& film,
                  const PassContext& context);

}  // namespace guidelight

#include "renderer/integrators/photon_mapping/photon_power.h"

#include <algorithm>

namespace guidelight {

double PhotonPower::chain_density(Color f, const PathVertex& vertex, const Scattering& scattering,
                                  bool for_caustic_map) const {
  const Color importance = for_caustic_map ? importance_.of_caustic(vertex, scattering)
                                           : importance_.of_global(vertex, scattering);
  return luminance(f * importance) / scale_;
}

Color PhotonPower::of_state(const glm::dvec3& f, double pdf, const PathVertex& vertex,
                            const Scattering& scattering, bool for_caustic_map) const {
  // Only ratios of f matter: brought into the range of single precision first.
  const double strongest = std::max({f.r, f.g, f.b});
  const Color color(f / strongest);
  const double of_chains = chain_density(color, vertex, scattering, for_caustic_map);
  if (!(of_chains > 0)) return Color(0);
  return color * static_cast<float>(1 / (of_chains + light_paths_ * pdf / strongest));
}

Color PhotonPower::of_light_path(const PathVertex& vertex, const Scattering& scattering,
                                 bool for_caustic_map) const {
  // What a light path carries is f over its density.
  const Color carried = vertex.throughput;
  const double of_chains = chain_density(carried, vertex, scattering, for_caustic_map);
  return carried * static_cast<float>(1 / (of_chains + light_paths_));
}

}  // namespace guidelight

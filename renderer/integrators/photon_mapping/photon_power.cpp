#include "renderer/integrators/photon_mapping/photon_power.h"

#include <algorithm>

namespace guidelight {

Color PhotonPower::of_state(const glm::dvec3& f, double pdf, Color importance) const {
  // Only ratios of f matter: brought into the range of single precision first.
  const double strongest = std::max({f.r, f.g, f.b});
  const Color color(f / strongest);
  const double of_chains = chain_density(color, importance);
  if (!(of_chains > 0)) return Color(0);
  return color * static_cast<float>(1 / (of_chains + light_paths_ * pdf / strongest));
}

Color PhotonPower::of_light_path(Color carried, Color importance) const {
  return carried * static_cast<float>(1 / (chain_density(carried, importance) + light_paths_));
}

}  // namespace guidelight

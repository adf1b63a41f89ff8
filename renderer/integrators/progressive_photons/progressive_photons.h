#pragma once

#include <vector>

#include "renderer/integrators/integrator.h"

namespace guidelight {

/// Progressive photon mapping (Hachisuka et al. 2008) and its stochastic variant (Hachisuka and
/// Jensen 2009). All light but what the camera sees by specular bounces alone is found by photons,
/// which are forgotten after each pass.
std::vector<IntegratorInfo> progressive_photon_infos();

}  // namespace guidelight

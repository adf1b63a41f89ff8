#pragma once

#include <vector>

#include "renderer/integrators/integrator.h"

namespace guidelight {

/// Light tracing, BDPT, probabilistic PPM (Knaus and Zwicker 2011), bidirectional photon mapping
/// with the nearest photons (Vorba 2011) or a fixed radius, and VCM (Georgiev et al. 2012): one
/// kernel, in which each takes part of the techniques.
std::vector<IntegratorInfo> bidirectional_infos();

}  // namespace guidelight

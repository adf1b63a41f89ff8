#pragma once

#include "renderer/integrators/integrator.h"

namespace guidelight {

/// Photon mapping in two passes (Jensen 1996; Jensen 2001, "Realistic Image Synthesis Using Photon
/// Mapping"): a global and a caustic map, direct light sampled, caustics seen directly, everything
/// else by a final gather with irradiance caching. Every pass emits photons anew, so the mean of
/// passes converges to the image that the radius of the estimates blurs.
IntegratorInfo photon_mapping_info();

}  // namespace guidelight

#pragma once

#include "renderer/integrators/integrator.h"

namespace guidelight {

/// Metropolis photon sampling with user paths (Fan, Chenney & Lai 2005): photon mapping whose
/// photons come from Markov chains over complete paths from light to eye, so that they lie where
/// they matter. Every pass is a round of its own: new photons, a picture from them.
IntegratorInfo mps_info();

}  // namespace guidelight

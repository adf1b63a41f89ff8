#pragma once

#include "renderer/integrators/integrator.h"

namespace guidelight {

/// Metropolis light transport over explicit paths (Veach & Guibas 1997; Veach 1997, chapter 11)
/// with guide paths (Fan et al. 2005, section 5). Chains live on from pass to pass; every pass also
/// draws independent paths that refine the picture's brightness.
IntegratorInfo mlt_info();

}  // namespace guidelight

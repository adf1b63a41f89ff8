#pragma once

#include "renderer/integrators/integrator.h"

namespace guidelight {

/// Metropolis light transport in primary sample space (Kelemen et al. 2002): the simple baseline. A
/// path is whatever the bidirectional path sampler makes of its random numbers.
IntegratorInfo pssmlt_info();

}  // namespace guidelight

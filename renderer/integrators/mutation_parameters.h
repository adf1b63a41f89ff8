#pragma once

#include <vector>

#include "renderer/integrators/parameters.h"
#include "renderer/metropolis/guided_chains.h"

namespace guidelight {

/// Appends how often each mutation of chains is tried.
void add_mutation_parameters(MutationWeights& weights, std::vector<Parameter>& list);

}  // namespace guidelight

#pragma once

#include <span>

#include "renderer/integrators/chain_statistics.h"
#include "renderer/metropolis/guided_chains.h"
#include "renderer/metropolis/primary_chain.h"
#include "renderer/metropolis/seeding.h"

namespace guidelight {

/// What chains have counted together, with the brightness of the picture and its error.
ChainStatistics describe_chains(const GuidedChains& chains, const Seeding& seeding);
ChainStatistics describe_chains(std::span<const PrimaryChain> chains, const Seeding& seeding);

}  // namespace guidelight

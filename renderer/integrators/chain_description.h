#pragma once

#include <span>

#include "renderer/integrators/chain_statistics.h"
#include "renderer/metropolis/primary_chain.h"
#include "renderer/metropolis/seeding.h"
#include "renderer/transport/guide_mixture.h"

namespace guidelight {

/// Sums what chains of one set of mutations have counted; `guides` may be null.
ChainStatistics sum_statistics(const MutationSet& mutations, std::span<const MarkovChain> chains,
                               const GuideMixture* guides);
ChainStatistics sum_statistics(std::span<const PrimaryChain> chains);

/// Adds the brightness of the picture and its error.
void describe_normalization(const Seeding& seeding, ChainStatistics& statistics);

}  // namespace guidelight

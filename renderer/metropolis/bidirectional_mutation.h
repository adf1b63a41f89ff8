#pragma once

#include <memory>

#include "renderer/metropolis/mutation.h"
#include "renderer/metropolis/path_lengths.h"
#include "renderer/transport/guide_mixture.h"

namespace guidelight {

/// Cuts a gap into a path, anywhere and of any length, and fills it anew by all bidirectional
/// techniques, perhaps with more or fewer vertices (Veach 1997, 11.3.1). Reaches every path from
/// every other: the mutation that makes a chain ergodic.
///
/// With guides it is one hybrid with the proposal that follows them, of which `guided` is the
/// share: whichever of the two has made a candidate, both densities count (Fan et al. 2005, section
/// 5.2).
std::unique_ptr<Mutation> make_bidirectional_mutation(
    const Scene& scene, const PathLengths& lengths,
    std::shared_ptr<const GuideMixture> guides = nullptr, float guided = 0);

}  // namespace guidelight

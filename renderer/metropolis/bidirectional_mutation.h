#pragma once

#include <memory>

#include "renderer/metropolis/mutation.h"
#include "renderer/metropolis/path_lengths.h"

namespace guidelight {

/// Cuts a gap into a path, anywhere and of any length, and fills it anew by all bidirectional
/// techniques, perhaps with more or fewer vertices (Veach 1997, 11.3.1). Reaches every path from
/// every other: the mutation that makes a chain ergodic.
std::unique_ptr<Mutation> make_bidirectional_mutation(const Scene& scene,
                                                      const PathLengths& lengths);

}  // namespace guidelight

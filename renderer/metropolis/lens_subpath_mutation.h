#pragma once

#include <memory>

#include "renderer/metropolis/mutation.h"
#include "renderer/metropolis/path_lengths.h"

namespace guidelight {

/// Replaces the path from the eye to its first finite vertex by one through a uniform place in the
/// picture, and joins it with what is kept: it spreads the chain over the picture (Veach 1997,
/// 11.3.4).
std::unique_ptr<Mutation> make_lens_subpath_mutation(const Scene& scene,
                                                     const PathLengths& lengths);

}  // namespace guidelight

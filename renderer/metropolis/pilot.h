#pragma once

#include <atomic>
#include <vector>

#include "renderer/metropolis/harvest.h"

namespace guidelight {

/// Guides from the paths of a short run of chains ("resampling" in Fan et al. 2005, section 5):
/// paths of three segments and more to anywhere in the picture, grouped as by harvest(). Each way
/// is stood for by a path drawn in proportion to the light that it brings, which is no freak of the
/// geometry as the brightest may be. Stops early when told to.
std::vector<HarvestedPath> pilot_guides(const Scene& scene, uint64_t mutations, size_t count,
                                        const std::atomic<bool>& stop);

}  // namespace guidelight

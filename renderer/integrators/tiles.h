#pragma once

#include <functional>

#include "renderer/integrators/integrator.h"

namespace guidelight {

/// Side of the square tiles in which pictures are rendered, and their pixels. A tile is one piece
/// of parallel work: small enough to stop within milliseconds, large enough to trace its rays in
/// batches.
inline constexpr int kTileSize = 16;
inline constexpr size_t kTilePixels = size_t{kTileSize} * kTileSize;

/// Calls render(tile) in parallel for every tile of the film's (or the context's) region.
void for_each_tile(const Film& film, const PassContext& context,
                   const std::function<void(const PixelRegion&)>& render);

}  // namespace guidelight

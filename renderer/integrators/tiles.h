#pragma once

#include <functional>

#include "renderer/integrators/integrator.h"

namespace guidelight {

/// Side of the square tiles in which pictures are rendered, and their pixels. A tile is one piece
/// of parallel work: small enough to stop within milliseconds, large enough to trace its rays in
/// batches.
inline constexpr int kTileSize = 16;
inline constexpr size_t kTilePixels = size_t{kTileSize} * kTileSize;

struct Tile {
  PixelRegion pixels;
  size_t index;
  size_t count;  // of all tiles of this pass

  /// The tile's share [first, last) of n things that all tiles divide between them.
  size_t first_of(size_t n) const { return n * index / count; }
  size_t last_of(size_t n) const { return n * (index + 1) / count; }
};

/// How many tiles for_each_tile visits.
size_t tile_count(const Film& film, const PassContext& context);

/// Calls render(tile) in parallel for every tile of the film's (or the context's) region.
void for_each_tile(const Film& film, const PassContext& context,
                   const std::function<void(const Tile&)>& render);

/// Writes what a camera ray sees first into its sample.
void record_first_hit(FilmSample& sample, const SurfacePoint& point, float distance);

}  // namespace guidelight

#include "renderer/integrators/tiles.h"

namespace guidelight {

namespace {

/// The part of the film that is rendered, cut into tiles.
struct Tiling {
  PixelRegion region;
  int columns;
  int rows;

  Tiling(const Film& film, const PassContext& context)
      : region(PixelRegion::whole(film.width(), film.height())) {
    if (context.region) region = intersection(region, *context.region);
    if (region.empty()) region = {};
    columns = (region.width() + kTileSize - 1) / kTileSize;
    rows = (region.height() + kTileSize - 1) / kTileSize;
  }

  size_t count() const { return static_cast<size_t>(columns) * rows; }

  PixelRegion tile(size_t i) const {
    const int x0 = region.x0 + static_cast<int>(i % columns) * kTileSize;
    const int y0 = region.y0 + static_cast<int>(i / columns) * kTileSize;
    return intersection(region, {x0, y0, x0 + kTileSize, y0 + kTileSize});
  }
};

}  // namespace

size_t tile_count(const Film& film, const PassContext& context) {
  return Tiling(film, context).count();
}

void for_each_tile(const Film& film, const PassContext& context,
                   const std::function<void(const Tile&)>& render) {
  const Tiling tiling(film, context);
  const size_t count = tiling.count();
  context.parallel->for_each(count, [&](size_t i) { render({tiling.tile(i), i, count}); });
}

void record_first_hit(FilmSample& sample, const SurfacePoint& point, float distance) {
  sample.albedo = point.bsdf->albedo(point);
  sample.normal = point.frame.n;
  sample.depth = distance;
}

}  // namespace guidelight

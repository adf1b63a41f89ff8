#include "renderer/integrators/tiles.h"

#include <algorithm>

namespace guidelight {

void for_each_tile(const Film& film, const PassContext& context,
                   const std::function<void(const PixelRegion&)>& render) {
  PixelRegion region{0, 0, film.width(), film.height()};
  if (context.region) {
    region.x0 = std::clamp(context.region->x0, 0, region.x1);
    region.y0 = std::clamp(context.region->y0, 0, region.y1);
    region.x1 = std::clamp(context.region->x1, region.x0, region.x1);
    region.y1 = std::clamp(context.region->y1, region.y0, region.y1);
  }
  const int columns = (region.x1 - region.x0 + kTileSize - 1) / kTileSize;
  const int rows = (region.y1 - region.y0 + kTileSize - 1) / kTileSize;
  context.parallel->for_each(static_cast<size_t>(columns) * rows, [&](size_t i) {
    const int x0 = region.x0 + static_cast<int>(i % columns) * kTileSize;
    const int y0 = region.y0 + static_cast<int>(i / columns) * kTileSize;
    render({x0, y0, std::min(x0 + kTileSize, region.x1), std::min(y0 + kTileSize, region.y1)});
  });
}

}  // namespace guidelight

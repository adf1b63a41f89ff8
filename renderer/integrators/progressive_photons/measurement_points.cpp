#include "renderer/integrators/progressive_photons/measurement_points.h"

namespace guidelight {

void MeasurementPoints::place(const Scene& scene, const CameraWalk::Paths& paths,
                              const SearchRadius& radius, const Film& film,
                              const PassContext& context) {
  const Key key{context.seed, film.width(), film.height(), context.region};
  if (placed_for_ == key) return;
  placed_for_.reset();
  tiles_.assign(tile_count(film, context), {});
  for_each_tile(film, context, [&](const Tile& tile) {
    TilePoints& placed = tiles_[tile.index];
    CameraWalk walk(scene, paths);
    walk.trace(tile.pixels, film.filter(),
               [&](uint32_t i, const PathVertex& vertex, const Scattering&) {
                 const CameraPath& path = walk.paths()[i];
                 placed.points.push_back(
                     {.point = {vertex.hit, vertex.point.position, vertex.wo},
                      .throughput = path.weight * vertex.throughput,
                      .initial_radius = radius.at(path.footprint ? &*path.footprint : nullptr),
                      .path = i,
                      .length = vertex.length});
               });
    placed.points.shrink_to_fit();
    const size_t pixels = walk.paths().size() / paths.per_pixel;
    for (size_t i = 0; i < pixels; ++i) placed.samples.push_back(walk.pixel_sample(i));
  });
  placed_for_ = key;
}

size_t MeasurementPoints::bytes() const {
  size_t sum = 0;
  for (const TilePoints& tile : tiles_) {
    sum += tile.points.capacity() * sizeof(MeasurementPoint) +
           tile.samples.capacity() * sizeof(FilmSample);
  }
  return sum;
}

}  // namespace guidelight

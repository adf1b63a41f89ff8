#pragma once

#include <optional>
#include <vector>

#include "renderer/integrators/progressive_photons/camera_walk.h"
#include "renderer/integrators/search_radius.h"
#include "renderer/transport/stored_point.h"

namespace guidelight {

/// A point at which light is measured in every pass.
struct MeasurementPoint {
  StoredPoint point;
  Color throughput;  // of the camera path, times its weight in the pixel
  float initial_radius;
  uint32_t path;   // of the tile's
  int32_t length;  // segments
};

struct TilePoints {
  std::vector<MeasurementPoint> points;
  std::vector<FilmSample> samples;  // of each pixel, without what the points will measure
};

/// The points of a picture, tile by tile.
class MeasurementPoints {
 public:
  /// Traces the points, if they are not there from the pass before. Throws Stopped.
  void place(const Scene& scene, const CameraWalk::Paths& paths, const SearchRadius& radius,
             const Film& film, const PassContext& context);

  const TilePoints& of(const Tile& tile) const { return tiles_[tile.index]; }
  size_t bytes() const;

 private:
  struct Key {
    uint64_t seed;
    int width;
    int height;
    std::optional<PixelRegion> region;
    bool operator==(const Key&) const = default;
  };

  std::optional<Key> placed_for_;
  std::vector<TilePoints> tiles_;
};

}  // namespace guidelight

#pragma once

#include <vector>

#include "renderer/integrators/photon_mapping/settings.h"
#include "renderer/integrators/tiles.h"
#include "renderer/photons/final_gather.h"

namespace guidelight {

/// The camera paths of a tile, by rows, and those of one pixel together. They draw the same random
/// numbers whenever they are traced, so that a vertex can be met again.
struct CameraPaths {
  std::vector<Subpath> paths;
  std::vector<float> filter_weights;
};
CameraPaths start_camera_paths(const PhotonMappingPass& setup, const PixelRegion& tile,
                               const Filter& filter);

/// Which vertices of camera paths gather indirect light, and how. A path goes on while it scatters
/// sharply; of a diffuse event, all light is estimated where it happens.
class GatherRule {
 public:
  explicit GatherRule(const PhotonMappingPass& setup) : setup_(setup) {}

  /// Whether a vertex is part of the camera path at all: everything before it scattered sharply.
  bool reaches(const Subpath& path) const {
    return path.length == 0 || setup_.global.sharp.at_origin(path);
  }
  /// Whether paths with a diffuse event here and another one behind are short enough.
  bool gathers(const PathVertex& vertex) const {
    return vertex.is_connectible() && vertex.length + 2 <= setup_.global.max_length;
  }
  /// The BSDF's value if irradiance may be cached here.
  std::optional<Color> cached_value(const PathVertex& vertex, const Scattering& scattering) const {
    if (!setup_.settings.irradiance_cache) return std::nullopt;
    return lambertian_value(vertex, scattering);
  }
  /// Records are shared between points with one key: what they may read depends on the length of
  /// the camera path if lengths are limited.
  int cache_key(const PathVertex& vertex) const {
    const bool is_limited = setup_.settings.max_length >= 0 || setup_.settings.min_length > 3;
    return is_limited ? vertex.length : 0;
  }
  /// Random numbers of a vertex of the i-th path of a tile.
  Rng rng(const PixelRegion& tile, uint32_t i, const PathVertex& vertex) const;

 private:
  const PhotonMappingPass& setup_;
};

/// Where the irradiance cache needs records, tile by tile.
class GatherPoints {
 public:
  GatherPoints(const PhotonMappingPass& setup, const GatheredLight& light);

  /// Gathers wherever the camera paths of a tile meet surfaces that records do not cover yet, from
  /// coarse to fine, so that the first records lie far apart. Records of other tiles are not looked
  /// at: the result is the same in whatever order tiles are done.
  std::vector<IrradianceRecord> trace(const PixelRegion& tile, const Filter& filter);

  // RandomWalk's visitor.
  void escaped(uint32_t, Subpath&) {}
  bool visit(uint32_t index, Subpath& path, const PathVertex& vertex, const Scattering& scattering);
  void end_segment() {}

 private:
  struct Point {
    uint32_t path;
    PathVertex vertex;
  };

  const PhotonMappingPass& setup_;
  GatherRule rule_;
  FinalGather gather_;
  RandomWalk walk_;
  std::vector<Point> points_;
};

/// An empty cache for a pass.
IrradianceCache make_cache(const PhotonMappingPass& setup);

}  // namespace guidelight

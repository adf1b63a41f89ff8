#include "renderer/integrators/photon_mapping/gather_points.h"

#include <algorithm>

namespace guidelight {

namespace {

constexpr uint64_t kGatherStream = 0x676174686572ull;

/// Pixels of the coarsest grid of a tile come first, then those halfway between, and so on.
int refinement_level(int x, int y) {
  int level = 0;
  for (int stride = kTileSize; stride > 1 && (x % stride || y % stride); stride /= 2) ++level;
  return level;
}

/// Of a pixel's first camera path, in the picture.
uint64_t path_number(const PhotonMappingPass& setup, int x, int y) {
  const auto pixel = static_cast<uint64_t>(y) * setup.scene.camera().width() + x;
  return pixel * setup.settings.camera_samples;
}

}  // namespace

CameraPaths start_camera_paths(const PhotonMappingPass& setup, const PixelRegion& tile,
                               const Filter& filter) {
  CameraPaths result;
  for (int y = tile.y0; y < tile.y1; ++y) {
    for (int x = tile.x0; x < tile.x1; ++x) {
      for (int i = 0; i < setup.settings.camera_samples; ++i) {
        Rng rng(setup.seed, setup.pass, path_number(setup, x, y) + i);
        const Filter::Sample offset = filter.sample(rng.next_vec2());
        const Vec2 raster = Vec2(x + 0.5f, y + 0.5f) + offset.offset;
        result.paths.push_back(start_camera_path(setup.scene, raster, rng));
        result.filter_weights.push_back(offset.weight);
      }
    }
  }
  return result;
}

Rng GatherRule::rng(const PixelRegion& tile, uint32_t i, const PathVertex& vertex) const {
  const int per_pixel = setup_.settings.camera_samples;
  const int pixel = static_cast<int>(i) / per_pixel;
  const int width = tile.x1 - tile.x0;
  const uint64_t path = path_number(setup_, tile.x0 + pixel % width, tile.y0 + pixel / width) +
                        i % static_cast<uint32_t>(per_pixel);
  return Rng(setup_.seed ^ kGatherStream, setup_.pass,
             static_cast<uint64_t>(vertex.length) << 48 | path);
}

GatherPoints::GatherPoints(const PhotonMappingPass& setup, const GatheredLight& light)
    : setup_(setup),
      rule_(setup),
      gather_(setup.scene, light),
      walk_(setup.scene, TransportMode::Radiance) {}

bool GatherPoints::visit(uint32_t index, Subpath& path, const PathVertex& vertex,
                         const Scattering& scattering) {
  if (!rule_.reaches(path) || vertex.length >= setup_.global.max_length) return false;
  if (rule_.gathers(vertex)) {
    const auto value = rule_.cached_value(vertex, scattering);
    if (value && !is_black(*value)) points_.push_back({index, vertex});
  }
  return SharpScattering::is_possible(*vertex.point.bsdf);
}

std::vector<IrradianceRecord> GatherPoints::trace(const PixelRegion& tile, const Filter& filter) {
  points_.clear();
  CameraPaths camera = start_camera_paths(setup_, tile, filter);
  walk_.run(camera.paths, *this);

  const int tile_width = tile.x1 - tile.x0;
  const auto level = [&](const Point& point) {
    const int i = static_cast<int>(point.path) / setup_.settings.camera_samples;
    return refinement_level(i % tile_width, i / tile_width);
  };
  std::stable_sort(points_.begin(), points_.end(),
                   [&](const Point& a, const Point& b) { return level(a) < level(b); });

  IrradianceCache cache = make_cache(setup_);
  for (const Point& point : points_) {
    const PathVertex& vertex = point.vertex;
    const int key = rule_.cache_key(vertex);
    if (cache.interpolate(vertex.point.position, normal_towards_viewer(vertex), key)) continue;
    IrradianceRecord record = gather_.irradiance(vertex, setup_.settings.gather_rays,
                                                 rule_.rng(tile, point.path, vertex));
    record.key = key;
    cache.insert(record);
  }
  return {cache.records().begin(), cache.records().end()};
}

IrradianceCache make_cache(const PhotonMappingPass& setup) {
  // The split sphere knows nothing of pixels or of the size of the scene: records are not closer
  // than a small part of it in corners, and not so far that they miss what rays did not find.
  const float radius = setup.scene.bounds().radius();
  return {setup.scene.bounds(),
          {.accuracy = setup.settings.cache_accuracy,
           .min_distance = 0.02f * radius,
           .max_distance = radius}};
}

}  // namespace guidelight

#pragma once

#include <functional>
#include <vector>

#include "renderer/integrators/tiles.h"
#include "renderer/transport/random_walk.h"
#include "renderer/transport/ray_footprint.h"

namespace guidelight {

/// A camera path of a pixel.
struct CameraPath {
  FilmSample sample{};  // what it saw first, and emission that it found by specular bounces alone
  float weight = 1;     // of the path among those of its pixel, pixel filter included
  std::optional<RayFootprint> footprint{};  // at its end, if wanted
};

/// Traces the camera paths of a tile to where light is measured: the first vertex that scatters by
/// a finite lobe. If it has a delta lobe too, as glossy paint has, the path goes on through that
/// lobe, and there may be a second such vertex. All other light is found by photons. One object
/// serves many tiles and keeps its memory.
class CameraWalk {
 public:
  struct Paths {
    int per_pixel;
    int min_length;  // segments
    int max_length;
    uint64_t seed;
    uint64_t pass;
    bool need_footprints;  // the caller asks for those of the paths
  };
  /// Called where path `index` is to measure light.
  using Measure =
      std::function<void(uint32_t index, const PathVertex& vertex, const Scattering& scattering)>;

  CameraWalk(const Scene& scene, const Paths& paths)
      : scene_(scene), settings_(paths), walk_(scene, TransportMode::Radiance) {}

  /// `per_pixel` paths for each pixel, row by row.
  void trace(const PixelRegion& tile, const Filter& filter, const Measure& measure);

  const std::vector<CameraPath>& paths() const { return paths_; }
  /// What the paths of the i-th pixel have seen.
  FilmSample pixel_sample(size_t i) const;

  // RandomWalk's visitor.
  void escaped(uint32_t index, Subpath& path);
  bool visit(uint32_t index, Subpath& path, const PathVertex& vertex, const Scattering& scattering);
  void end_segment() {}

 private:
  void add_emission(uint32_t index, int length, Color radiance);

  const Scene& scene_;
  Paths settings_;
  RandomWalk walk_;
  const Measure* measure_ = nullptr;
  std::vector<Subpath> subpaths_;
  std::vector<CameraPath> paths_;
};

}  // namespace guidelight

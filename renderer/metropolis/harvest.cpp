#include "renderer/metropolis/harvest.h"

#include "renderer/metropolis/bidirectional_sampler.h"
#include "renderer/metropolis/ways.h"
#include "renderer/sampling/random.h"

namespace guidelight {
namespace {

constexpr int kLongestWay = 12;  // segments

/// A camera whose whole picture is a part of another's.
Camera camera_of_region(const Camera& camera, const PixelRegion& region) {
  FilmDescription film = camera.film();
  const bool cropped = film.crop_width > 0;
  film.crop_x = (cropped ? film.crop_x : 0) + region.x0;
  film.crop_y = (cropped ? film.crop_y : 0) + region.y0;
  film.crop_width = region.width();
  film.crop_height = region.height();
  film.filter = {.kind = FilterKind::Box};  // which does not reach beyond it
  return {camera.description(), film};
}

}  // namespace

std::vector<HarvestedPath> harvest(const Scene& scene, const PixelRegion& region, int samples,
                                   size_t count, const std::atomic<bool>& stop) {
  const auto seen = scene.with_camera(camera_of_region(scene.camera(), region));
  const PathSampler sampler(*seen, {2, kLongestWay});
  Ways ways(scene);
  Path path;
  for (int i = 0; i < samples && !stop; ++i) {
    Rng rng(0, 0, static_cast<uint64_t>(i));
    const double density = sampler.sample(path, rng);
    if (!(density > 0) || !(path.target() > 0)) continue;
    const double contribution = path.target() / density;
    ways.add(path, contribution, contribution);
  }
  return ways.strongest(count);
}

}  // namespace guidelight

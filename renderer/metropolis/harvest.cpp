#include "renderer/metropolis/harvest.h"

#include <algorithm>
#include <map>

#include "renderer/metropolis/bidirectional_sampler.h"
#include "renderer/sampling/random.h"

namespace guidelight {
namespace {

constexpr int kLongestPath = 12;  // segments

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

/// Light and shapes that a path visits, and whether each scatters by a delta lobe.
std::vector<uint32_t> itinerary(const Path& path) {
  std::vector<uint32_t> key = {path.light->index};
  for (int i = 1; i + 1 < path.size(); ++i) {
    key.push_back(path.points[i].point.shape);
    key.push_back(path.points[i].event);
  }
  return key;
}

/// The part of a path that a guide can lead: up to the last vertex that scatters.
GuidePath guide_along(const Scene& scene, const Path& path) {
  GuidePath guide;
  int last = path.size() - 2;
  while (last > 0 && !path.is_finite(last)) --last;
  const PathPoint& light = path.points[0];
  const Vec3 start = path.light->is_infinite() ? path.points[1].point.position -
                                                     2 * scene.bounds().radius() * light.direction
                                               : light.point.position;
  guide.vertices.push_back({start});
  for (int i = 1; i <= last; ++i) {
    guide.vertices.push_back({path.points[i].point.position, path_event(path.points[i].event)});
    guide.name += (i > 1 ? ", " : "") + scene.shape_name(path.points[i].point.shape);
  }
  guide.disc_radius = 0.01f * scene.bounds().radius();
  return guide;
}

struct Way {
  double contribution = 0;
  double strongest = 0;
  GuidePath guide;
};

}  // namespace

std::vector<HarvestedPath> harvest(const Scene& scene, const PixelRegion& region, int samples,
                                   size_t count, const std::atomic<bool>& stop) {
  const auto seen = scene.with_camera(camera_of_region(scene.camera(), region));
  const PathSampler sampler(*seen, {2, kLongestPath});
  std::map<std::vector<uint32_t>, Way> ways;
  double total = 0;
  Path path;
  for (int i = 0; i < samples && !stop; ++i) {
    Rng rng(0, 0, static_cast<uint64_t>(i));
    const double density = sampler.sample(path, rng);
    if (!(density > 0) || !(path.target() > 0)) continue;
    const double contribution = path.target() / density;
    total += contribution;
    Way& way = ways[itinerary(path)];
    way.contribution += contribution;
    if (contribution <= way.strongest) continue;
    way.strongest = contribution;
    way.guide = guide_along(scene, path);
  }
  std::vector<HarvestedPath> harvested;
  for (auto& [key, way] : ways) {
    if (way.guide.vertices.size() < 2) continue;
    harvested.push_back({std::move(way.guide), way.contribution / total});
  }
  std::ranges::sort(harvested, std::greater{}, &HarvestedPath::share);
  if (harvested.size() > count) harvested.resize(count);
  return harvested;
}

}  // namespace guidelight

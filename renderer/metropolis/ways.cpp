#include "renderer/metropolis/ways.h"

#include <algorithm>

namespace guidelight {

namespace {

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

}  // namespace

void Ways::add(const Path& path, double contribution, double rank) {
  total_ += contribution;
  const auto [place, is_new] = ways_.try_emplace(itinerary(path));
  Way& way = place->second;
  way.contribution += contribution;
  if (!is_new && rank <= way.rank) return;
  way.rank = rank;
  way.guide = guide_along(scene_, path);
}

std::vector<HarvestedPath> Ways::strongest(size_t count) const {
  std::vector<HarvestedPath> list;
  for (const auto& [key, way] : ways_) {
    if (way.guide.vertices.size() >= 2) list.push_back({way.guide, way.contribution / total_});
  }
  std::ranges::sort(list, std::greater{}, &HarvestedPath::share);
  if (list.size() > count) list.resize(count);
  return list;
}

}  // namespace guidelight

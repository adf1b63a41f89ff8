#include "ui/guides/guide_draft.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "renderer/transport/guide_check.h"

namespace guidelight {
namespace {

constexpr int kMostClearSurfaces = 16;
constexpr float kDiscShare = 0.4f;           // of the radius of a disc of the light's area
constexpr float kLargestDiscShare = 0.015f;  // of the scene's radius

bool scatters(const SurfacePoint& point) { return point.bsdf->lobes() & kLobeSmooth; }

float suitable_disc(const Scene& scene, const LightPlace& place) {
  const float largest = kLargestDiscShare * scene.bounds().radius();
  if (!place.point.light) return largest;
  const float per_area =
      place.light->pdf_emission(place.point, place.point.geometric_normal).position;
  return per_area > 0 ? std::min(largest, kDiscShare * std::sqrt(kInvPi / per_area)) : largest;
}

/// The first light on a ray behind nothing but clear surfaces; whether the ray left the scene.
std::optional<SurfacePoint> light_on_ray(const Scene& scene, Ray ray, bool& escaped) {
  for (int i = 0; i < kMostClearSurfaces; ++i) {
    const Hit hit = scene.intersect(ray);
    escaped = !hit.valid();
    if (escaped) return std::nullopt;
    SurfacePoint point = scene.surface_point(ray, hit);
    if (point.light) return point;
    if (!(point.bsdf->lobes() & kLobeDeltaTransmission)) return std::nullopt;
    const float passed = glm::distance(ray.origin, point.position);
    ray = {point.offset_origin(ray.direction), ray.direction, ray.t_max - passed};
  }
  return std::nullopt;
}

std::optional<LightPlace> light_in_sky(const Scene& scene, Vec3 direction) {
  LightPlace place;
  for (const Light* light : scene.infinite_lights()) {
    if (light->is_delta_direction()) {
      const auto emission = light->sample_emission(Vec2(0.5f), Vec2(0.5f));
      if (place.light || !emission) continue;
      place.light = light;
      place.towards_sky = -emission->ray.direction;
    } else if (!is_black(light->radiance_from(direction))) {
      place.light = light;
      place.towards_sky = direction;
    }
  }
  return place.light ? std::optional(place) : std::nullopt;
}

}  // namespace

std::optional<LightPlace> pick_light(const Scene& scene, const Ray& ray,
                                     const std::function<bool(Vec3)>& is_near) {
  const auto with_disc = [&](LightPlace place) {
    place.disc_radius = suitable_disc(scene, place);
    return place;
  };
  bool escaped = false;
  if (const auto point = light_on_ray(scene, ray, escaped)) {
    LightPlace place;
    place.light = point->light;
    place.point = *point;
    return with_disc(place);
  }
  for (const auto& light : scene.lights()) {
    if (!light->is_delta_position()) continue;
    const auto emission = light->sample_emission(Vec2(0.5f), Vec2(0.5f));
    if (!emission || !is_near(emission->ray.origin)) continue;
    LightPlace place;
    place.light = light.get();
    place.point.position = emission->ray.origin;
    return with_disc(place);
  }
  if (!escaped) return std::nullopt;
  const auto sky = light_in_sky(scene, ray.direction);
  return sky ? std::optional(with_disc(*sky)) : std::nullopt;
}

void GuideDraft::begin(const Scene& scene, const LightPlace& light) {
  clear();
  sky_distance_ = 2 * scene.bounds().radius();
  light_ = light;
}

void GuideDraft::clear() {
  light_.reset();
  segments_.clear();
}

/// Where a path from the light to `next` starts.
Vec3 GuideDraft::start_before(Vec3 next) const {
  const bool in_sky = light_->towards_sky != Vec3(0);
  return in_sky ? next + sky_distance_ * light_->towards_sky : light_->point.position;
}

Continuation GuideDraft::aim(const Scene& scene, const SurfacePoint& target,
                             SpecularChoice choice) const {
  const bool from_light = segments_.empty();
  const SurfacePoint& from = from_light ? light_->point : segments_.back().end;
  const Vec3 start = from_light ? start_before(target.position) : from.position;
  const float tolerance = guide_tolerance(scene);
  Continuation next;
  next.end = target;
  if (glm::distance(start, target.position) <= tolerance) {
    next.problem = "the path is here already";
    return next;
  }
  const Vec3 direction = glm::normalize(target.position - start);
  const Ray ray = from.bsdf ? from.spawn_ray(direction) : Ray{start, direction, kInfinity};
  auto segment = trace_guide_segment(scene, ray, choice);
  const auto arrives = [&] {
    return segment && glm::distance(segment->end.position, target.position) <= tolerance;
  };
  // Glass on the way bends the path away from what was aimed at; another direction gets there.
  if (scatters(target) && !arrives() && segment && segment->vertices.size() > 1) {
    const auto solved = solve_guide_segment(scene, from, direction, target.position, choice);
    if (solved) segment = solved;
  }
  if (!segment) {
    next.problem = scatters(target) ? "nothing scatters light on this way"
                                    : "from this surface the path leaves the scene";
    return next;
  }
  next.vertices = segment->vertices;
  next.end = segment->end;
  if (from_light && from.light && glm::dot(direction, from.geometric_normal) <= 0) {
    const bool shines = !is_black(from.light->radiance(from, direction));
    if (!shines) next.problem = "the light does not shine this way";
  }
  if (scatters(target) && !arrives()) {
    next.problem = fmt::format("'{}' is in the way", scene.shape_name(segment->end.shape));
  }
  return next;
}

void GuideDraft::take(const Scene& scene, const GuidePath& traced) {
  segments_.clear();
  Continuation segment;
  for (size_t i = 1; i < traced.vertices.size(); ++i) {
    segment.vertices.push_back(traced.vertices[i]);
    if (traced.vertices[i].event != PathEvent::Scatter) continue;
    const Vec3 before = traced.vertices[i - 1].position;
    const Vec3 way = traced.vertices[i].position - before;
    const Ray ray{before + 1e-3f * way, glm::normalize(way), kInfinity};
    const Hit hit = scene.intersect(ray);
    if (!hit.valid()) return;
    segment.end = scene.surface_point(ray, hit);
    segments_.push_back(std::exchange(segment, {}));
  }
}

void GuideDraft::remove_last() {
  if (segments_.empty()) {
    light_.reset();
  } else {
    segments_.pop_back();
  }
}

std::optional<Vec3> GuideDraft::light_position() const {
  if (!light_ || light_->towards_sky != Vec3(0)) return std::nullopt;
  return light_->point.position;
}

std::vector<Vec3> GuideDraft::points() const {
  std::vector<Vec3> points;
  if (segments_.empty()) {
    if (const auto position = light_position()) points.push_back(*position);
    return points;
  }
  for (const GuideVertex& vertex : path().vertices) points.push_back(vertex.position);
  return points;
}

GuidePath GuideDraft::path() const {
  GuidePath path;
  path.disc_radius = light_->disc_radius;
  path.vertices.push_back({start_before(segments_.front().vertices.front().position)});
  for (const Continuation& segment : segments_) {
    path.vertices.insert(path.vertices.end(), segment.vertices.begin(), segment.vertices.end());
  }
  return path;
}

}  // namespace guidelight

#include "renderer/transport/path_growth.h"

#include "renderer/scene/bsdf/scattering.h"

namespace guidelight {

namespace {

/// Of the lights at infinity that can be hit, the one that u chooses.
const Light* choose_infinite_light(const Scene& scene, float u) {
  const float probability = infinite_light_probability(scene);
  if (probability == 0) return nullptr;
  auto remaining = static_cast<int>(u / probability);
  for (const Light* light : scene.infinite_lights()) {
    if (!light->is_delta() && remaining-- == 0) return light;
  }
  return nullptr;
}

Lobe event_of(const ScatteringSample& sample) {
  return sample.is_delta() ? sample.lobe : kLobeNone;
}

/// Draws a direction at a vertex reached from `wo`.
template <typename Random>
std::optional<ScatteringSample> scatter(PathPoint& x, Vec3 wo, TransportMode mode, Random& rng) {
  const float u_lobe = rng.next_float();
  auto sample = Scattering(x.point, wo, mode).sample(u_lobe, rng.next_vec2());
  if (!sample || is_black(sample->weight)) return std::nullopt;
  x.event = event_of(*sample);
  return sample;
}

}  // namespace

void start_from(Path& path, const Light& light, const EmissionSample& emission) {
  path.light = &light;
  PathPoint& x0 = path.points[0];
  x0.event = kLobeNone;
  x0.point = light.is_infinite() ? SurfacePoint{} : emission.point;
  if (light.is_delta_position()) x0.point.position = emission.ray.origin;
  x0.direction = emission.ray.direction;
}

template <typename Random>
bool sample_light(const Scene& scene, Path& path, Random& rng, Ray& ray) {
  const auto choice = scene.choose_light(rng.next_float());
  if (!choice) return false;
  const Vec2 u_position = rng.next_vec2();
  const auto sample = choice->light->sample_emission(u_position, rng.next_vec2());
  // The first direction may be dark and the light still be seen from elsewhere.
  if (!sample) return false;
  start_from(path, *choice->light, *sample);
  ray = sample->ray;
  return true;
}

void sample_lens(const Scene& scene, Path& path, Vec2 raster, Vec2 u_lens, Ray& ray) {
  const CameraSample sample = scene.camera().sample_ray(raster, u_lens);
  path.lens().event = kLobeNone;
  path.lens().point = {};
  path.lens().point.position = sample.lens_position;
  ray = sample.ray;
}

bool connect_to_lens(const Scene& scene, Path& path, Vec2 u_lens) {
  const auto connection =
      scene.camera().connect(path.points[path.size() - 2].point.position, u_lens);
  if (!connection) return false;
  path.lens().event = kLobeNone;
  path.lens().point = {};
  path.lens().point.position = connection->lens_position;
  return true;
}

bool arrive_from_light(const Scene& scene, Path& path, int i, const Ray& ray) {
  const Hit hit = scene.intersect(ray);
  if (!hit.valid()) return false;
  path.points[i].point = scene.surface_point(ray, hit);
  path.points[i].event = kLobeNone;
  return true;
}

bool arrive_from_eye(const Scene& scene, Path& path, int i, const Ray& ray, float u) {
  const Hit hit = scene.intersect(ray);
  PathPoint& x = path.points[i];
  x.event = kLobeNone;
  if (hit.valid()) {
    x.point = scene.surface_point(ray, hit);
    if (i == 0) path.light = x.point.light;
    return i > 0 || path.light != nullptr;
  }
  if (i > 0) return false;
  path.light = choose_infinite_light(scene, u);
  x.point = {};
  x.direction = -ray.direction;
  return path.light != nullptr;
}

template <typename Random>
bool scatter_to_eye(const Scene& scene, Path& path, int i, Vec3 to_light, Random& rng) {
  const auto sample = scatter(path.points[i], to_light, TransportMode::Importance, rng);
  return sample &&
         arrive_from_light(scene, path, i + 1, path.points[i].point.spawn_ray(sample->wi));
}

template <typename Random>
bool scatter_to_light(const Scene& scene, Path& path, int i, Vec3 to_eye, Random& rng) {
  const auto sample = scatter(path.points[i], to_eye, TransportMode::Radiance, rng);
  const float u = i == 1 ? rng.next_float() : 0.0f;
  return sample &&
         arrive_from_eye(scene, path, i - 1, path.points[i].point.spawn_ray(sample->wi), u);
}

bool follow_to_eye(const Scene& scene, Path& path, int from, int to, Ray ray) {
  for (int i = from + 1; i <= to; ++i) {
    const Lobe event = path.points[i].event;
    if (!arrive_from_light(scene, path, i, ray)) return false;
    if (i == to) break;
    const SurfacePoint& point = path.points[i].point;
    const auto next = Scattering(point, -ray.direction, TransportMode::Importance).specular(event);
    if (!next) return false;
    path.points[i].event = event;
    ray = point.spawn_ray(next->wi);
  }
  return true;
}

bool follow_to_light(const Scene& scene, Path& path, int from, int to, Ray ray, float u) {
  for (int i = from - 1; i >= to; --i) {
    const Lobe event = path.points[i].event;
    if (!arrive_from_eye(scene, path, i, ray, u)) return false;
    if (i == to) break;
    const SurfacePoint& point = path.points[i].point;
    const auto next = Scattering(point, -ray.direction, TransportMode::Radiance).specular(event);
    if (!next) return false;
    path.points[i].event = event;
    ray = point.spawn_ray(next->wi);
  }
  return true;
}

Vec3 direction_to_light(const Path& path, int i) {
  if (i == 1 && path.light->is_infinite()) return -path.points[0].direction;
  return glm::normalize(path.points[i - 1].point.position - path.points[i].point.position);
}

Vec3 direction_to_eye(const Path& path, int i) {
  return glm::normalize(path.points[i + 1].point.position - path.points[i].point.position);
}

bool may_scatter_finitely(const Path& path, int i) {
  return i == 0 || i == path.length() || path.points[i].point.bsdf->lobes() & kLobeSmooth;
}

bool join(Path& path, int i) {
  path.points[i].event = path.points[i + 1].event = kLobeNone;
  return may_scatter_finitely(path, i) && may_scatter_finitely(path, i + 1);
}

bool is_visible(const Scene& scene, const Path& path, int i) {
  const SurfacePoint& a = path.points[i].point;
  const SurfacePoint& b = path.points[i + 1].point;
  const bool from_light = i == 0;
  if (from_light && path.light->is_infinite()) {
    return !scene.occluded(b.spawn_ray(-path.points[0].direction));
  }
  if (from_light && path.light->is_delta()) return !scene.occluded(b.spawn_ray_to(a.position));
  if (i + 1 < path.length()) return !scene.occluded(b.spawn_ray_to(a));
  // Nothing between the lens and the near clip stands in the way.
  const Camera& camera = scene.camera();
  const Vec3 w = path.points[i].direction;
  const float clipped = camera.description().near_clip / -glm::dot(camera.forward(), w);
  return !scene.occluded(a.spawn_ray_to(b.position - clipped * w));
}

template bool sample_light(const Scene&, Path&, Rng&, Ray&);
template bool sample_light(const Scene&, Path&, PrimarySamples&, Ray&);
template bool scatter_to_eye(const Scene&, Path&, int, Vec3, Rng&);
template bool scatter_to_eye(const Scene&, Path&, int, Vec3, PrimarySamples&);
template bool scatter_to_light(const Scene&, Path&, int, Vec3, Rng&);
template bool scatter_to_light(const Scene&, Path&, int, Vec3, PrimarySamples&);

}  // namespace guidelight

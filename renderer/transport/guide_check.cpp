#include "renderer/transport/guide_check.h"

#include "renderer/error.h"
#include "renderer/scene/bsdf/scattering.h"

namespace guidelight {

namespace {

constexpr size_t kMaxVertices = 64;
/// Between the direction of a guide and that of parallel light [rad].
constexpr float kParallelTolerance = 1e-3f;

bool is_in(float value, float lower, float upper) { return value >= lower && value <= upper; }

/// What can be said without a scene.
void check_numbers(const GuidePath& guide, std::vector<GuideFault>& faults) {
  const auto count = guide.vertices.size();
  if (count < 2) {
    faults.emplace_back(0, "it has fewer than two vertices: add one on a surface that it lights");
  } else if (count > kMaxVertices) {
    faults.emplace_back(0, fmt::format("it has {} vertices: give at most {}", count, kMaxVertices));
  }
  if (!is_in(guide.weight, 0, 1e30f)) {
    faults.emplace_back(0, "its weight is not a number from 0 upwards: give one");
  }
  if (!(guide.disc_radius > 0 && guide.disc_radius < 1e30f)) {
    faults.emplace_back(0, "its disc radius is not a positive number: give one");
  }
  for (size_t i = 0; i < count; ++i) {
    const GuideVertex& vertex = guide.vertices[i];
    const int index = static_cast<int>(i);
    if (!is_finite(vertex.position)) {
      faults.emplace_back(index, "its position is not finite: give three numbers");
    }
    const bool is_free = vertex.event == PathEvent::Scatter && i + 1 < count;
    if (is_free && !(vertex.cone > 0 && vertex.cone <= 0.5f * kPi)) {
      faults.emplace_back(index, "its cone is not an angle above 0 and up to 90 degrees: give one");
    }
  }
  if (count > 0 && guide.vertices[0].event != PathEvent::Scatter) {
    faults.emplace_back(0, "a light neither reflects nor refracts: its event must be 'scatter'");
  }
}

/// The point light at a position.
std::optional<LightOrigin> find_point_light(const Scene& scene, Vec3 position, Vec3 direction) {
  for (const auto& light : scene.lights()) {
    if (!light->is_delta_position()) continue;
    const auto sample = light->sample_emission(Vec2(0.5f), Vec2(0.5f));
    if (!sample || glm::distance(sample->ray.origin, position) > guide_tolerance(scene)) continue;
    LightOrigin origin{light.get(), {}};
    origin.point.position = sample->ray.origin;
    if (!is_black(emitted_light(*light, origin.point, direction))) return origin;
  }
  return std::nullopt;
}

/// The brightest light at infinity that shines along a direction; parallel light goes first.
std::optional<LightOrigin> find_infinite_light(const Scene& scene, Vec3 position, Vec3 direction) {
  const float reach =
      2 * scene.bounds().radius() + glm::distance(position, scene.bounds().center());
  if (scene.occluded({position, -direction, 2 * reach})) return std::nullopt;
  LightOrigin brightest{nullptr, {}};
  brightest.point.position = position;
  float largest = 0;
  for (const Light* light : scene.infinite_lights()) {
    const Color emitted = emitted_light(*light, {}, direction);
    if (is_black(emitted)) continue;
    if (light->is_delta_direction()) return LightOrigin{light, brightest.point};
    if (luminance(emitted) > largest) largest = luminance(emitted), brightest.light = light;
  }
  return brightest.light ? std::optional(brightest) : std::nullopt;
}

/// Finds the vertices of a guide one after another.
class Placing {
 public:
  Placing(const Scene& scene, const GuidePath& guide, std::vector<GuideFault>& faults)
      : scene_(scene), guide_(guide), faults_(faults), tolerance_(guide_tolerance(scene)) {}

  PlacedGuide run() {
    const auto& vertices = guide_.vertices;
    if (const auto far = far_vertex()) {
      fault(*far, "it is far outside of the scene: move it into it");
      return {};
    }
    const Vec3 first = vertices[1].position - vertices[0].position;
    if (!(glm::length(first) > 0)) {
      fault(1, "it is where the vertex before is: move one of them");
      return {};
    }
    const auto origin = find_light(scene_, vertices[0].position, glm::normalize(first));
    if (!origin) {
      fault(0, "there is no light here that shines towards the next vertex: move it onto one");
      return {};
    }
    PlacedGuide placed{origin->light, {origin->point}};
    ray_ = first_ray(*origin);
    for (int i = 1; i < static_cast<int>(vertices.size()); ++i) {
      const auto point = arrive(i);
      if (!point) break;
      placed.points.push_back(*point);
      if (!leave(i, *point)) break;
    }
    return placed;
  }

 private:
  void fault(int vertex, std::string message) { faults_.emplace_back(vertex, std::move(message)); }

  /// A vertex from which directions could not be computed any more.
  std::optional<int> far_vertex() const {
    constexpr float kFar = 1e6f;  // radii of the scene
    const Bounds bounds = scene_.bounds();
    for (size_t i = 0; i < guide_.vertices.size(); ++i) {
      const float distance = glm::distance(guide_.vertices[i].position, bounds.center());
      if (!(distance <= kFar * bounds.radius())) return static_cast<int>(i);
    }
    return std::nullopt;
  }

  Ray first_ray(const LightOrigin& origin) const {
    const Vec3 direction = glm::normalize(guide_.vertices[1].position - origin.point.position);
    return origin.point.spawn_ray(direction);
  }

  std::optional<SurfacePoint> arrive(int i) {
    const Vec3 expected = guide_.vertices[i].position;
    const bool is_free = guide_.vertices[i - 1].event == PathEvent::Scatter;
    const Hit hit = scene_.intersect(ray_);
    if (!hit.valid()) {
      fault(i, is_free ? "there is no surface on the way to it: move it onto one"
                       : "the specular surface before it sends the path out of the scene: trace "
                         "this part again");
      return std::nullopt;
    }
    const SurfacePoint point = scene_.surface_point(ray_, hit);
    const float missed = glm::distance(point.position, expected);
    if (missed > tolerance_) {
      const bool is_before = hit.t < glm::distance(ray_.origin, expected);
      fault(i, is_free && is_before
                   ? fmt::format("'{}' blocks the segment to it, {:.4g} before: move one of its "
                                 "ends",
                                 scene_.shape_name(point.shape), missed)
               : is_free ? fmt::format("it is {:.4g} before the surface: move it there", missed)
                         : fmt::format("the specular surface before it leads to a point {:.4g} "
                                       "away: trace this part again",
                                       missed));
      return std::nullopt;
    }
    return point;
  }

  /// Checks the event at a vertex and sets the ray to the next.
  bool leave(int i, const SurfacePoint& point) {
    const bool scatters = point.bsdf->lobes() & kLobeSmooth;
    const auto& vertices = guide_.vertices;
    if (i + 1 == static_cast<int>(vertices.size())) {
      if (!scatters) {
        fault(i, fmt::format("it ends on '{}', which scatters nothing: let it end on a diffuse "
                             "surface",
                             scene_.shape_name(point.shape)));
      }
      return scatters;
    }
    const PathEvent event = vertices[i].event;
    if (event == PathEvent::Scatter) {
      if (!scatters) {
        fault(i, fmt::format("'{}' is a mirror or clear glass: its event must be 'reflect' or "
                             "'refract'",
                             scene_.shape_name(point.shape)));
        return false;
      }
      const Vec3 direction = vertices[i + 1].position - point.position;
      if (!(glm::length(direction) > 0)) {
        fault(i + 1, "it is where the vertex before is: move one of them");
        return false;
      }
      ray_ = point.spawn_ray(glm::normalize(direction));
      return true;
    }
    const Lobe lobe = event == PathEvent::Reflect ? kLobeDeltaReflection : kLobeDeltaTransmission;
    const Scattering scattering(point, -ray_.direction, TransportMode::Importance);
    const auto sample = scattering.specular(lobe);
    if (!sample || is_black(sample->weight)) {
      fault(i, fmt::format("'{}' does not {} here: change its event or trace this part again",
                           scene_.shape_name(point.shape),
                           event == PathEvent::Reflect ? "reflect like a mirror" : "refract"));
      return false;
    }
    ray_ = point.spawn_ray(sample->wi);
    return true;
  }

  const Scene& scene_;
  const GuidePath& guide_;
  std::vector<GuideFault>& faults_;
  float tolerance_;
  Ray ray_;
};

}  // namespace

float guide_tolerance(const Scene& scene) { return 1e-3f * scene.bounds().radius(); }

Color emitted_light(const Light& light, const SurfacePoint& point, Vec3 direction) {
  if (light.is_delta_direction()) {
    const auto sample = light.sample_direct(point.position, Vec2(0.5f));
    const bool is_along =
        sample && length_squared(sample->wi + direction) <= sqr(kParallelTolerance);
    return is_along ? sample->radiance : Color(0);
  }
  if (light.is_delta_position()) {
    const auto sample = light.sample_direct(point.position + direction, Vec2(0.5f));
    return sample ? sample->radiance * sqr(sample->distance) : Color(0);
  }
  return light.is_infinite() ? light.radiance_from(-direction) : light.radiance(point, direction);
}

std::optional<LightOrigin> find_light(const Scene& scene, Vec3 position, Vec3 direction) {
  const float tolerance = guide_tolerance(scene);
  const Ray back{position + tolerance * direction, -direction, 2 * tolerance};
  const Hit hit = scene.intersect(back);
  if (hit.valid()) {
    const SurfacePoint point = scene.surface_point(back, hit);
    if (point.light && !is_black(point.light->radiance(point, direction))) {
      return LightOrigin{point.light, point};
    }
  }
  if (const auto origin = find_point_light(scene, position, direction)) return origin;
  return find_infinite_light(scene, position, direction);
}

PlacedGuide place_guide(const Scene& scene, const GuidePath& guide,
                        std::vector<GuideFault>& faults) {
  const size_t before = faults.size();
  check_numbers(guide, faults);
  if (faults.size() > before) return {};
  return Placing(scene, guide, faults).run();
}

std::vector<GuideFault> check_guide(const Scene& scene, const GuidePath& guide) {
  std::vector<GuideFault> faults;
  place_guide(scene, guide, faults);
  return faults;
}

}  // namespace guidelight

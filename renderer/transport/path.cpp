#include "renderer/transport/path.h"

#include <algorithm>
#include <cmath>

#include "renderer/scene/bsdf/scattering.h"

namespace guidelight {

namespace {

bool is_parallel(const Camera& camera) {
  return camera.description().model == CameraModel::Orthographic;
}

float abs_cos(const SurfacePoint& point, Vec3 w) {
  return std::abs(glm::dot(point.geometric_normal, w));
}

/// Of a direction that arrives at the lens; 1 where all arrive in parallel.
float lens_cosine(const Camera& camera, Vec3 w) {
  return is_parallel(camera) ? 1.0f : -glm::dot(camera.forward(), w);
}

}  // namespace

float infinite_light_probability(const Scene& scene) {
  const auto lights = scene.infinite_lights();
  const auto count =
      std::count_if(lights.begin(), lights.end(), [](const Light* l) { return !l->is_delta(); });
  return count > 0 ? 1.0f / static_cast<float>(count) : 0.0f;
}

void Path::splice(const Path& path, int from_light, int inserted, int from_eye) {
  points.resize(from_light + inserted + from_eye);
  std::copy_n(path.points.begin(), from_light, points.begin());
  std::copy_n(path.points.end() - from_eye, from_eye, points.end() - from_eye);
  light = path.light;
  raster = path.raster;
  guide = kNoGuide;
  pdf_light_ = path.pdf_light_;
  pdf_lens_ = path.pdf_lens_;
  hit_probability_ = path.hit_probability_;
}

bool Path::update(const Scene& scene, int first, int last) {
  const int k = length();
  contribution_ = glm::dvec3(0);
  target_ = 0;
  for (int i = std::max(first - 1, 0); i <= std::min(last, k - 1); ++i) {
    if (!update_edge(scene, i)) return false;
  }
  if (first <= 1 && !update_light(scene)) return false;
  if (last >= k - 1 && !update_lens(scene)) return false;
  for (int i = std::max(first - 1, 1); i <= std::min(last + 1, k - 1); ++i) {
    if (!(points[i].event == kLobeNone ? update_scattering(i) : update_specular(i))) return false;
  }
  update_transmittance(scene);
  update_contribution();
  return target_ > 0 && std::isfinite(target_);
}

bool Path::update_edge(const Scene& scene, int i) {
  PathPoint& a = points[i];
  const PathPoint& b = points[i + 1];
  const bool at_lens = i == length() - 1;
  if (i == 0 && light->is_infinite()) {
    // The direction is the vertex.
    a.distance = kInfinity;
    a.arrival_eye =
        at_lens ? lens_cosine(scene.camera(), a.direction) : abs_cos(b.point, a.direction);
    a.arrival_light = 1;
    return a.arrival_eye > 0;
  }
  const Vec3 to_next = b.point.position - a.point.position;
  const float squared = length_squared(to_next);
  if (!(squared > 0)) return false;
  a.distance = std::sqrt(squared);
  a.direction = to_next / a.distance;
  const bool from_point = i == 0 && light->is_delta_position();
  const float cos_a = from_point ? 1.0f : abs_cos(a.point, a.direction);
  if (at_lens && is_parallel(scene.camera())) {
    a.arrival_eye = 1;
    a.arrival_light = cos_a;
    return cos_a > 0;
  }
  const float cos_b =
      at_lens ? lens_cosine(scene.camera(), a.direction) : abs_cos(b.point, a.direction);
  a.arrival_eye = cos_b / squared;
  a.arrival_light = cos_a / squared;
  return cos_a > 0 && cos_b > 0;
}

bool Path::update_light(const Scene& scene) {
  PathPoint& x0 = points[0];
  const EmissionPdf pdf = light->pdf_emission(x0.point, x0.direction);
  const bool infinite = light->is_infinite();
  if (light->is_delta()) {
    const auto sample = light->sample_direct(points[1].point.position, Vec2(0));
    if (!sample) return false;
    x0.value = infinite ? sample->radiance : sample->radiance * sqr(x0.distance);
  } else {
    x0.value = infinite ? light->radiance_from(-x0.direction)
                        : light->radiance(x0.point, x0.direction) * abs_cos(x0.point, x0.direction);
  }
  // At infinity the direction stands for the vertex, and the place across the rays for what
  // follows.
  x0.pdf_to_eye = infinite ? pdf.position : pdf.direction;
  const float pdf_vertex = light->is_delta() ? 1.0f : infinite ? pdf.direction : pdf.position;
  pdf_light_ = scene.light_probability(*light) * pdf_vertex;
  hit_probability_ = light->is_delta() ? 0.0f : infinite ? infinite_light_probability(scene) : 1.0f;
  return !is_black(x0.value);
}

bool Path::update_lens(const Scene& scene) {
  const Camera& camera = scene.camera();
  const Vec3 position = lens().point.position;
  const Vec3 w = -points[size() - 2].direction;
  const auto where = camera.raster_of(position, w);
  if (!where) return false;
  raster = *where;
  const float importance = camera.importance(position, w);
  lens().value = Color(importance);
  const float pdf = camera.pdf_direction(position, w);
  lens().pdf_to_light = pdf / camera.raster_excess();
  pdf_lens_ = importance * lens_cosine(camera, -w) / pdf;
  return importance > 0;
}

bool Path::update_scattering(int i) {
  PathPoint& x = points[i];
  const Scattering scattering(x.point, -points[i - 1].direction, TransportMode::Importance);
  const BsdfEvaluation evaluation = scattering.evaluate(x.direction);
  x.value = evaluation.value;
  x.pdf_to_eye = evaluation.pdf;
  x.pdf_to_light = evaluation.pdf_reverse;
  x.jacobian = 1;
  return !is_black(x.value);
}

bool Path::update_specular(int i) {
  PathPoint& x = points[i];
  const Vec3 to_light = -points[i - 1].direction;
  const auto forward = Scattering(x.point, to_light, TransportMode::Importance).specular(x.event);
  const auto backward = Scattering(x.point, x.direction, TransportMode::Radiance).specular(x.event);
  // A mixture may have two such lobes and report the other one.
  constexpr float kSameDirection = 0.999f;
  if (!forward || glm::dot(forward->wi, x.direction) < kSameDirection) return false;
  if (!backward || glm::dot(backward->wi, to_light) < kSameDirection) return false;
  x.value = forward->weight * forward->pdf;
  x.pdf_to_eye = forward->pdf;
  const bool straight = forward->eta == 1 && forward->wi == -to_light;
  const float cos_light = std::abs(glm::dot(x.point.frame.n, to_light));
  const float cos_eye = std::abs(glm::dot(x.point.frame.n, x.direction));
  x.jacobian = straight ? 1.0f : sqr(backward->eta) * cos_light / cos_eye;
  x.pdf_to_light = backward->pdf * x.jacobian;
  return !is_black(x.value);
}

template <typename Visit>
void Path::visit_media(const Scene& scene, int first, Visit&& visit) const {
  // The camera knows what it is in; beyond an interface, the interface does.
  const Medium* medium = scene.camera_medium();
  for (int i = length() - 1; i >= first; --i) {
    visit(i, medium);
    if (i > 0) medium = medium_beyond(points[i].point, -points[i - 1].direction, medium);
  }
}

const Medium* Path::medium(const Scene& scene, int i) const {
  const Medium* result = nullptr;
  visit_media(scene, i, [&](int, const Medium* medium) { result = medium; });
  return result;
}

void Path::update_transmittance(const Scene& scene) {
  visit_media(scene, 0, [&](int i, const Medium* medium) {
    points[i].transmittance = medium ? medium->transmittance(points[i].distance) : Color(1);
  });
}

void Path::update_contribution() {
  glm::dvec3 f(lens().value);
  for (int i = 0; i < length(); ++i) {
    const PathPoint& x = points[i];
    f *= glm::dvec3(x.value * x.transmittance) * double{x.arrival_eye};
  }
  contribution_ = f;
  target_ = 0.2126 * f.r + 0.7152 * f.g + 0.0722 * f.b;
}

double Path::pdf_from_eye(int i) const {
  if (i == length()) return pdf_lens_;
  const double pdf = double{points[i + 1].pdf_to_light} * points[i].arrival_light;
  return i == 0 ? pdf * hit_probability_ : pdf;
}

bool Path::is_connectible_edge(int i) const {
  // With nothing from the light's side, the last vertex from the eye is itself on the light.
  if (i == 0) return true;
  return length() > 1 && i < size() && is_finite(i - 1) && is_finite(i);
}

namespace {

bool same_place(const PathPoint& a, const PathPoint& b) {
  return a.point.position == b.point.position && a.point.shape == b.point.shape;
}

}  // namespace

int shared_from_light(const Path& a, const Path& b) {
  if (a.light != b.light) return 0;
  const bool is_direction = a.light->is_infinite();
  const int limit = std::min(a.size(), b.size());
  for (int i = 0; i < limit; ++i) {
    const PathPoint& p = a.points[i];
    const PathPoint& q = b.points[i];
    const bool same = i == 0 && is_direction ? p.direction == q.direction : same_place(p, q);
    if (!same) return i;
    if (p.event != q.event) return i + 1;
  }
  return limit;
}

int shared_from_eye(const Path& a, const Path& b) {
  const int limit = std::min(a.size(), b.size());
  for (int i = 1; i <= limit; ++i) {
    const PathPoint& p = a.points[a.size() - i];
    const PathPoint& q = b.points[b.size() - i];
    if (!same_place(p, q)) return i - 1;
    if (p.event != q.event) return i;
  }
  return limit;
}

int Path::next_finite_towards_light(int from) const {
  int i = from - 1;
  while (i > 0 && !is_finite(i)) --i;
  return std::max(i, 0);
}

}  // namespace guidelight

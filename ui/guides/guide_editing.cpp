#include "ui/guides/guide_editing.h"

#include <algorithm>

#include "renderer/sampling/random.h"
#include "renderer/scene/bsdf/scattering.h"
#include "renderer/transport/guide_check.h"
#include "renderer/transport/guide_mixture.h"

namespace guidelight {
namespace {

/// A guide whose segments are traced again one by one.
class Retracing {
 public:
  Retracing(const Scene& scene, GuidePath guide) : scene_(scene), guide_(std::move(guide)) {}

  GuidePath take() { return std::move(guide_); }
  GuideVertex& vertex(int i) { return guide_.vertices[i]; }
  int last() const { return static_cast<int>(guide_.vertices.size()) - 1; }

  bool is_free(int i) const {
    return i == 0 || i == last() || guide_.vertices[i].event == PathEvent::Scatter;
  }
  int free_before(int i) const {
    do --i;
    while (!is_free(i));
    return i;
  }
  int free_after(int i) const {
    do ++i;
    while (!is_free(i));
    return i;
  }

  /// Finds the specular vertices between two free ones anew; returns the new index of the second.
  int solve(int from, int to) {
    if (to == from + 1) return to;
    const auto start = surface_at(from);
    if (!start) return to;
    const Vec3 guess = glm::normalize(vertex(from + 1).position - vertex(from).position);
    const auto segment =
        solve_guide_segment(scene_, *start, guess, vertex(to).position, choice_after(from));
    return segment ? replace(from, to, *segment) : to;
  }

  /// Sends a segment in another direction; returns the new index of its end.
  int shoot(int from, int to, Vec3 towards) {
    const auto start = surface_at(from);
    if (!start || start->position == towards) return to;
    const Vec3 direction = glm::normalize(towards - start->position);
    const auto segment =
        trace_guide_segment(scene_, start->spawn_ray(direction), choice_after(from));
    return segment ? replace(from, to, *segment) : to;
  }

 private:
  SpecularChoice choice_after(int from) {
    return vertex(from + 1).event == PathEvent::Reflect ? SpecularChoice::Reflect
                                                        : SpecularChoice::Refract;
  }

  int replace(int from, int to, const GuideSegment& segment) {
    const GuideVertex old_end = vertex(to);
    auto& vertices = guide_.vertices;
    vertices.erase(vertices.begin() + from + 1, vertices.begin() + to + 1);
    vertices.insert(vertices.begin() + from + 1, segment.vertices.begin(), segment.vertices.end());
    const int end = from + static_cast<int>(segment.vertices.size());
    vertex(end).cone = old_end.cone;
    return end;
  }

  /// The surface that a vertex lies on; of lights without surface the position alone.
  std::optional<SurfacePoint> surface_at(int i) {
    if (i == 0) {
      const Vec3 direction = glm::normalize(vertex(1).position - vertex(0).position);
      const auto origin = find_light(scene_, vertex(0).position, direction);
      return origin ? std::optional(origin->point) : std::nullopt;
    }
    constexpr float kOffTheSurface = 1e-3f;
    const Vec3 way = vertex(i).position - vertex(i - 1).position;
    const Ray ray{vertex(i - 1).position + kOffTheSurface * way, glm::normalize(way), kInfinity};
    const Hit hit = scene_.intersect(ray);
    if (!hit.valid()) return std::nullopt;
    const SurfacePoint point = scene_.surface_point(ray, hit);
    const bool found = glm::distance(point.position, vertex(i).position) <= guide_tolerance(scene_);
    return found ? std::optional(point) : std::nullopt;
  }

  const Scene& scene_;
  GuidePath guide_;
};

/// Follows one draw of the mixture's only guide.
GuideCandidates::Candidate draw_candidate(const Scene& scene, const GuideMixture& mixture,
                                          Rng& rng) {
  GuideCandidates::Candidate candidate;
  const Vec2 u_position = rng.next_vec2();
  const auto start = mixture.start(0, u_position, rng.next_vec2());
  if (!start) return candidate;
  Ray ray = start->emission.ray;
  candidate.points.push_back(ray.origin);
  for (int i = 1;; ++i) {
    const Hit hit = scene.intersect(ray);
    if (!hit.valid()) return candidate;
    const SurfacePoint point = scene.surface_point(ray, hit);
    candidate.points.push_back(point.position);
    const Scattering scattering(point, -ray.direction, TransportMode::Importance);
    if (i == mixture.length(0)) {
      candidate.valid = scattering.is_connectible();
      return candidate;
    }
    const PathEvent event = mixture.event(0, i);
    if (event == PathEvent::Scatter) {
      const Vec3 direction = mixture.sample_direction(0, i, rng.next_vec2());
      if (is_black(scattering.value(direction))) return candidate;
      ray = point.spawn_ray(direction);
    } else {
      const auto next = scattering.specular(lobe_of(event));
      if (!next) return candidate;
      ray = point.spawn_ray(next->wi);
    }
  }
}

}  // namespace

GuidePath move_guide_vertex(const Scene& scene, const GuidePath& guide, int moved,
                            const SurfacePoint& to) {
  Retracing path(scene, guide);
  const bool scatters = to.bsdf->lobes() & kLobeSmooth;
  if (!path.is_free(moved)) {
    if (scatters) return guide;
    const int from = path.free_before(moved);
    const int end = path.shoot(from, path.free_after(moved), to.position);
    if (end < path.last()) path.solve(end, path.free_after(end));
    return path.take();
  }
  if (moved == 0 ? !to.light : !scatters) return guide;
  for (const int neighbour : {moved - 1, moved + 1}) {
    const bool exists = neighbour >= 0 && neighbour <= path.last();
    if (exists && path.vertex(neighbour).position == to.position) return guide;
  }
  path.vertex(moved).position = to.position;
  const int end = moved == 0 ? 0 : path.solve(path.free_before(moved), moved);
  if (end < path.last()) path.solve(end, path.free_after(end));
  return path.take();
}

float GuideCandidates::valid_share() const {
  if (candidates.empty()) return 0;
  const auto valid = std::ranges::count_if(candidates, &Candidate::valid);
  return static_cast<float>(valid) / static_cast<float>(candidates.size());
}

GuideCandidates sample_candidates(const std::shared_ptr<const Scene>& scene, GuidePath guide,
                                  int count) {
  guide.enabled = true;
  guide.weight = 1;
  const std::vector<GuidePath> alone = {std::move(guide)};
  const auto mixture = GuideMixture::build(scene, alone);
  GuideCandidates result;
  if (!mixture) return result;
  Rng rng(0, 0, 0);
  for (int i = 0; i < count; ++i) {
    result.candidates.push_back(draw_candidate(*scene, *mixture, rng));
  }
  return result;
}

}  // namespace guidelight

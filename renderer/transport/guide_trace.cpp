#include "renderer/transport/guide_trace.h"

#include "renderer/scene/bsdf/scattering.h"
#include "renderer/scene/reach.h"
#include "renderer/transport/guide_check.h"

namespace guidelight {

namespace {

constexpr int kMaxSpecularVertices = 32;

/// The specular event at a point; the chosen kind goes first.
std::optional<ScatteringSample> specular_event(const SurfacePoint& point, Vec3 wo,
                                               SpecularChoice choice) {
  const Scattering scattering(point, wo, TransportMode::Importance);
  const bool reflects_first = choice == SpecularChoice::Reflect;
  for (const bool reflects : {reflects_first, !reflects_first}) {
    const auto event =
        scattering.specular(reflects ? kLobeDeltaReflection : kLobeDeltaTransmission);
    if (event && !is_black(event->weight)) return event;
  }
  return std::nullopt;
}

bool have_same_events(const GuideSegment& a, const GuideSegment& b) {
  return std::ranges::equal(a.vertices, b.vertices, {}, &GuideVertex::event, &GuideVertex::event);
}

/// One step of Gauss and Newton: the change (α,β) of the two angles by which the three residuals r
/// with derivatives along the two angles vanish best.
std::optional<Vec2> least_squares(Vec3 along_a, Vec3 along_b, Vec3 residual) {
  const float aa = glm::dot(along_a, along_a);
  const float ab = glm::dot(along_a, along_b);
  const float bb = glm::dot(along_b, along_b);
  const float determinant = aa * bb - ab * ab;
  if (!(determinant > 1e-12f * aa * bb)) return std::nullopt;
  const float ra = glm::dot(along_a, residual);
  const float rb = glm::dot(along_b, residual);
  return Vec2(ab * rb - bb * ra, ab * ra - aa * rb) / determinant;
}

}  // namespace

std::optional<GuideSegment> trace_guide_segment(const Scene& scene, Ray ray,
                                                SpecularChoice choice) {
  GuideSegment segment;
  while (segment.vertices.size() <= kMaxSpecularVertices) {
    const Hit hit = scene.intersect(ray);
    if (!hit.valid()) return std::nullopt;
    const SurfacePoint point = scene.surface_point(ray, hit);
    segment.vertices.push_back({point.position});
    if (point.bsdf->lobes() & kLobeSmooth) {
      segment.end = point;
      segment.arrival = ray.direction;
      return segment;
    }
    const auto event = specular_event(point, -ray.direction, choice);
    if (!event) return std::nullopt;
    segment.vertices.back().event = path_event(event->lobe);
    ray = point.spawn_ray(event->wi);
  }
  return std::nullopt;
}

namespace {

/// `next_direction(segment, i)` leads from the end of a segment to the next, the i-th.
template <typename NextDirection>
std::optional<GuidePath> trace_segments(const Scene& scene, Vec3 start, Vec3 direction,
                                        size_t count, SpecularChoice choice,
                                        NextDirection next_direction) {
  GuidePath guide;
  if (!is_within(start, kLargestCoordinate) || !is_finite(direction)) return std::nullopt;
  const auto origin = find_light(scene, start, direction);
  if (!origin) return std::nullopt;
  guide.vertices.push_back({origin->point.position});
  Ray ray = origin->point.spawn_ray(direction);
  for (size_t i = 0; i < count;) {
    const auto segment = trace_guide_segment(scene, ray, choice);
    if (!segment) break;
    guide.vertices.insert(guide.vertices.end(), segment->vertices.begin(), segment->vertices.end());
    if (++i < count) ray = segment->end.spawn_ray(next_direction(*segment, i));
  }
  return guide.vertices.size() > 1 ? std::optional(guide) : std::nullopt;
}

}  // namespace

std::optional<GuidePath> trace_guide(const Scene& scene, Vec3 start, Vec3 direction, int bounces,
                                     SpecularChoice choice) {
  const auto as_from_a_mirror = [](const GuideSegment& segment, size_t) {
    return glm::reflect(segment.arrival, segment.end.geometric_normal);
  };
  return trace_segments(scene, start, direction, static_cast<size_t>(std::max(bounces, 0)), choice,
                        as_from_a_mirror);
}

std::optional<GuidePath> trace_guide_through(const Scene& scene, Vec3 start,
                                             std::span<const Vec3> targets, SpecularChoice choice) {
  if (targets.empty()) return std::nullopt;
  const auto towards_target = [&](const GuideSegment& segment, size_t i) {
    return glm::normalize(targets[i] - segment.end.position);
  };
  return trace_segments(scene, start, glm::normalize(targets[0] - start), targets.size(), choice,
                        towards_target);
}

std::optional<GuideSegment> solve_guide_segment(const Scene& scene, const SurfacePoint& from,
                                                Vec3 guess, Vec3 target, SpecularChoice choice) {
  constexpr int kMaxSteps = 40;
  constexpr float kDelta = 1e-3f;  // [rad], for differences
  const float close_enough = 0.01f * guide_tolerance(scene);
  const auto shoot = [&](Vec3 direction) {
    return trace_guide_segment(scene, from.spawn_ray(direction), choice);
  };
  auto best = shoot(guess);
  if (!best) return std::nullopt;
  const auto same_events = [&](const std::optional<GuideSegment>& segment) {
    return segment && have_same_events(*segment, *best);
  };

  Vec3 direction = guess;
  for (int step = 0; step < kMaxSteps; ++step) {
    const Vec3 residual = best->end.position - target;
    if (glm::length(residual) <= close_enough) return best;
    const Frame frame = Frame::from_normal(direction);
    const auto turned = [&](Vec2 angles) {
      return glm::normalize(direction + angles.x * frame.s + angles.y * frame.t);
    };
    const auto beside_a = shoot(turned({kDelta, 0}));
    const auto beside_b = shoot(turned({0, kDelta}));
    if (!same_events(beside_a) || !same_events(beside_b)) return std::nullopt;
    const auto change =
        least_squares((beside_a->end.position - best->end.position) / kDelta,
                      (beside_b->end.position - best->end.position) / kDelta, residual);
    if (!change) return std::nullopt;
    // Half the step until it helps: the specular surfaces bend more than the derivatives tell.
    bool helps = false;
    for (float share = 1; share > 1e-3f && !helps; share *= 0.5f) {
      const auto next = shoot(turned(share * *change));
      helps =
          same_events(next) && glm::distance(next->end.position, target) < glm::length(residual);
      if (!helps) continue;
      direction = turned(share * *change);
      best = next;
    }
    if (!helps) break;
  }
  // Rounding may leave it a little beside.
  const bool is_there = glm::distance(best->end.position, target) <= guide_tolerance(scene);
  return is_there ? best : std::nullopt;
}

}  // namespace guidelight

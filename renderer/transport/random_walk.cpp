#include "renderer/transport/random_walk.h"

#include <algorithm>

#include "renderer/transport/guided_walk.h"

namespace guidelight {

namespace {

/// Paths of dark surfaces are not cut so short that their few survivors become fireflies.
constexpr float kLowestSurvival = 0.1f;
/// Light that glass or mirrors without loss hold for ever is given up after a hundred segments.
constexpr float kHighestSurvival = 0.99f;

/// Guides draw directions that a BSDF hardly would, and the ratios of densities multiply: beyond
/// this a weight is 0 anyway, and infinity times the 0 of a technique that is off would be no
/// number.
constexpr float kLargestPartial = 1e30f;
float bounded(float partial) { return std::min(partial, kLargestPartial); }

/// Density of next-event estimation over that of emission for the point on the light where the path
/// began, as its first vertex sees it; choosing the light cancels. Times the squared distance
/// between them, which may be 0.
float direct_over_emission(const Subpath& path, const SurfacePoint& vertex, float squared) {
  const Light& light = *path.light;
  if (light.is_delta()) return squared;
  const EmissionSample& emission = *path.emission;
  if (light.is_infinite()) {
    return squared * light.pdf_direct_from(-path.ray.direction) / emission.pdf_direction;
  }
  return light.pdf_direct(vertex.position, emission.point) * emission.cos_light /
         emission.pdf_position;
}

/// Fills what the vertex at the end of a segment carries of the balance heuristic.
void add_partials(const Subpath& path, PathVertex& vertex) {
  // Densities per solid angle become densities per area by cosθ/d² (Veach 1997, 8.10); the d² of
  // both directions cancel in the chain.
  const float cos_here = std::abs(glm::dot(vertex.wo, vertex.point.geometric_normal));
  const float squared =
      path.is_parallel ? 1.0f : length_squared(vertex.point.position - path.origin);
  const float inverse = bounded(1 / (path.pdf * cos_here));
  const float chain = inverse * path.cos_origin;
  vertex.partials.connection = bounded(chain * path.sums.connection);
  vertex.partials.merging = bounded(chain * path.sums.merging);
  vertex.merging_before_last = bounded(chain * path.merging_before_origin);
  if (path.is_connectible) {
    const float directly = path.light ? direct_over_emission(path, vertex.point, squared) : squared;
    vertex.partials.inverse_pdf = bounded(inverse * directly);
  }
}

}  // namespace

float survival_probability(const SurfacePoint& point) {
  return std::clamp(max_component(point.bsdf->albedo(point)), kLowestSurvival, kHighestSurvival);
}

EscapePartials escape_partials(const Subpath& path) {
  const float inverse_pdf = bounded(1 / path.pdf);
  const float chain = inverse_pdf * path.cos_origin;
  return {{.inverse_pdf = path.is_connectible ? inverse_pdf : 0.0f,
           .connection = bounded(chain * path.sums.connection),
           .merging = bounded(chain * path.sums.merging)},
          bounded(chain * path.merging_before_origin)};
}

PathVertex RandomWalk::arrive(const Subpath& path, const Hit& hit) const {
  PathVertex vertex{.point = scene_.surface_point(path.ray, hit),
                    .hit = hit,
                    .wo = -path.ray.direction,
                    .throughput = path.throughput,
                    .partials = {},
                    .merging_before_last = 0,
                    .medium = path.medium,
                    .survival = 1,
                    .length = path.length + 1,
                    .merge_share = path.merge_share,
                    .is_specular_chain = path.is_specular_chain};
  if (path.medium) vertex.throughput *= path.medium->transmittance(hit.t);
  vertex.survival = survival_probability(vertex.point);
  if (weights_) add_partials(path, vertex);
  return vertex;
}

std::optional<ScatteringSample> RandomWalk::draw(Subpath& path, const PathVertex& vertex,
                                                 const Scattering& scattering) const {
  if (path.guided && path.guided->follows_guide()) {
    return path.guided->sample(vertex.length, scattering, path.rng);
  }
  if (vertex.survival < 1 && path.rng.next_float() >= vertex.survival) return std::nullopt;
  const float u_lobe = path.rng.next_float();
  return scattering.sample(u_lobe, path.rng.next_vec2());
}

void RandomWalk::close_sums(Subpath& path, const PathVertex& vertex,
                            const ScatteringSample& sample) const {
  if (sample.is_delta()) {
    // The discrete probability is the same from the other side: Fresnel's reflectance is.
    path.sums = mis_sums_at_delta(vertex.partials, sample.pdf * vertex.survival);
    path.merging_before_origin = path.sums.merging;
    return;
  }
  const bool from_light = mode_ == TransportMode::Importance;
  const float count = from_light ? weights_->count_before_light_vertex(vertex.length)
                                 : weights_->count_before_camera_vertex(vertex.length);
  const float mergeable =
      from_light ? weights_->mergeable_light_vertex(vertex.length) : vertex.merge_share;
  path.sums = mis_sums(vertex.partials, path.pdf_backward, count, mergeable,
                       from_light ? weights_->independence(path.pdf_backward) : 1.0f);
  if (!from_light) path.merge_share *= weights_->independence(sample.pdf * vertex.survival);
  path.merging_before_origin = path.pdf_backward * vertex.partials.merging;
}

bool RandomWalk::scatter(Subpath& path, const PathVertex& vertex,
                         const Scattering& scattering) const {
  const auto sample = draw(path, vertex, scattering);
  if (!sample || is_black(sample->weight)) return false;

  if (!sample->is_delta()) {
    // Also without weights: photons ask how sharp a scattering was from both ends.
    path.pdf_backward = scattering.pdf_reverse(sample->wi) * vertex.survival;
  }
  if (weights_) close_sums(path, vertex, *sample);
  path.is_connectible = !sample->is_delta();
  path.is_specular_chain &= sample->is_delta();
  path.throughput = vertex.throughput * sample->weight / vertex.survival;
  if (path.guided) {
    path.throughput *= path.guided->scatter(vertex.length, scattering, *sample, vertex.survival);
  }
  path.pdf = sample->pdf * vertex.survival;
  path.cos_origin = std::abs(glm::dot(sample->wi, vertex.point.geometric_normal));
  path.origin = vertex.point.position;
  path.medium = medium_beyond(vertex.point, sample->wi, vertex.medium);
  path.ray = vertex.point.spawn_ray(sample->wi);
  path.length = vertex.length;
  path.is_parallel = false;
  path.light = nullptr;
  path.emission = nullptr;
  return path.pdf > 0;
}

}  // namespace guidelight

#include "renderer/transport/path_weights.h"

#include <cmath>

namespace guidelight {

namespace {

/// Density of emission, `ray_origin` being any point of the segment.
float guided_pdf(const GuidedEmission* guided, const Light& light, const SurfacePoint& point,
                 Vec3 ray_origin, Vec3 direction, float pdf) {
  return guided ? pdf * guided->density_ratio(light, point, ray_origin, direction, pdf) : pdf;
}

}  // namespace

float path_weight(const MisWeights& weights, const PathVertex& vertex,
                  const DirectConnection& connection, float eta) {
  const MisSums sums = mis_sums(vertex.partials, connection.pdf_backward,
                                weights.count_before_camera_vertex(vertex.length),
                                weights.mergeable_light_vertex(1) * vertex.merge_share);
  return weights.next_event(sums, connection.emission_ratio, connection.hit_ratio, eta);
}

float path_weight(const MisWeights& weights, const PathVertex& light, const PathVertex& camera,
                  const VertexConnection& connection, float eta) {
  const MisSums light_sums = mis_sums(light.partials, connection.pdf_backward_light,
                                      weights.count_before_light_vertex(light.length),
                                      weights.mergeable_light_vertex(light.length),
                                      weights.independence(connection.pdf_backward_light));
  const MisSums camera_sums =
      mis_sums(camera.partials, connection.pdf_backward_camera,
               weights.count_before_camera_vertex(camera.length), camera.merge_share);
  return weights.connection(
      light_sums, connection.pdf_arrival_light, camera_sums, connection.pdf_arrival_camera, eta,
      camera.merge_share * weights.independence(connection.pdf_scattering_camera));
}

float path_weight(const MisWeights& weights, const PathVertex& vertex,
                  const LensConnection& connection, float eta) {
  const bool can_merge = weights.counts().merge_direct || !vertex.is_caustic();
  const MisSums sums = mis_sums(vertex.partials, connection.pdf_backward,
                                weights.count_before_light_vertex(vertex.length),
                                can_merge ? weights.mergeable_light_vertex(vertex.length) : 0.0f,
                                weights.independence(connection.pdf_backward));
  return weights.light_tracing(sums, connection.pdf_arrival, eta);
}

EmissionEnd end_on_light(const Scene& scene, const Subpath& path, const PathVertex& vertex,
                         bool is_direct_caustic, const GuidedEmission* guided) {
  const Light& light = *vertex.point.light;
  const float probability = scene.light_probability(light);
  const EmissionPdf emission = light.pdf_emission(vertex.point, vertex.wo);
  const float to_area = std::abs(glm::dot(vertex.wo, vertex.point.geometric_normal)) /
                        length_squared(vertex.point.position - path.origin);
  const float pdf = probability * emission.position * emission.direction;
  return {vertex.partials, vertex.merging_before_last, is_direct_caustic,
          probability * light.pdf_direct(path.origin, vertex.point) * to_area,
          guided_pdf(guided, light, vertex.point, path.origin, vertex.wo, pdf)};
}

EmissionEnd end_at_infinity(const Scene& scene, const Subpath& path, const Light& light,
                            bool is_direct_caustic, const GuidedEmission* guided) {
  const Vec3 towards = path.ray.direction;
  const float probability = scene.light_probability(light);
  const EmissionPdf emission = light.pdf_emission({}, -towards);
  const EscapePartials end = escape_partials(path);
  const float pdf = probability * emission.position * emission.direction;
  return {end.partials, end.merging_before_last, is_direct_caustic,
          probability * light.pdf_direct_from(towards),
          guided_pdf(guided, light, {}, path.origin, -towards, pdf)};
}

float path_weight(const MisWeights& weights, const EmissionEnd& end, float eta) {
  MisPartials partials = end.partials;
  if (!weights.counts().merge_direct) {
    // A merge at the last vertex would be one of direct light, and one at the first a directly
    // visible caustic if all others are specular.
    partials.merging = end.is_direct_caustic ? 0.0f : end.merging_before_last;
  }
  return weights.emission(partials, end.pdf_direct, end.pdf_emission, eta);
}

float path_weight(const MisWeights& weights, const PathVertex& vertex, const Merge& merge,
                  float eta) {
  // The merge itself stands apart, so no technique is counted at its own vertex.
  return weights.merging(mis_sums(merge.photon, merge.pdf_to_light,
                                  weights.count_before_light_vertex(merge.photon_length), 0.0f,
                                  weights.independence(merge.pdf_to_light)),
                         mis_sums(vertex.partials, merge.pdf_to_camera,
                                  weights.count_before_camera_vertex(vertex.length), 0.0f),
                         eta, vertex.merge_share);
}

}  // namespace guidelight

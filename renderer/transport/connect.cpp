#include "renderer/transport/connect.h"

#include <cmath>

namespace guidelight {

namespace {

float abs_cos_geometric(const PathVertex& vertex, Vec3 w) {
  return std::abs(glm::dot(vertex.point.geometric_normal, w));
}

}  // namespace

std::optional<DirectConnection> connect_to_light(const Scene& scene, const PathVertex& vertex,
                                                 const Scattering& scattering, float u_light,
                                                 Vec2 u_point, const GuidedEmission* guided) {
  const auto choice = scene.choose_light(u_light);
  if (!choice) return std::nullopt;
  const Light& light = *choice->light;
  const SurfacePoint& point = vertex.point;
  const auto sample = light.sample_direct(point.position, u_point);
  if (!sample || is_black(sample->radiance)) return std::nullopt;
  const BsdfEvaluation bsdf = scattering.evaluate(sample->wi);
  if (is_black(bsdf.value)) return std::nullopt;

  DirectConnection result;
  const float pdf = sample->pdf * choice->probability;
  result.contribution = vertex.throughput * bsdf.value * sample->radiance / pdf *
                        segment_transmittance(vertex, sample->wi, sample->distance);
  result.pdf_backward = bsdf.pdf_reverse * vertex.survival;
  result.hit_ratio = light.is_delta() ? 0.0f : bsdf.pdf * vertex.survival / pdf;
  // Emission: position × direction, taken to the vertex by cosθ/d². Direct: pdf per solid angle,
  // taken to the light by cosθ_light/d². The squares cancel except where direct light has no
  // density to convert.
  result.emission_ratio = sample->pdf_position * sample->pdf_direction *
                          abs_cos_geometric(vertex, sample->wi) / (sample->pdf * sample->cos_light);
  if (light.is_delta_position()) result.emission_ratio /= sqr(sample->distance);
  if (guided) {
    const double pdf_emission =
        double{choice->probability} * sample->pdf_position * sample->pdf_direction;
    result.emission_ratio *=
        guided->density_ratio(light, sample->point, point.position, -sample->wi, pdf_emission);
  }
  result.shadow_ray = light.is_infinite() ? point.spawn_ray(sample->wi)
                      : light.is_delta()  ? point.spawn_ray_to(sample->position)
                                          : point.spawn_ray_to(sample->point);
  return result;
}

std::optional<VertexConnection> connect_vertices(const PathVertex& light,
                                                 const Scattering& light_scattering,
                                                 const PathVertex& camera,
                                                 const Scattering& camera_scattering) {
  const Vec3 to_light = light.point.position - camera.point.position;
  const float squared = length_squared(to_light);
  if (!(squared > 0)) return std::nullopt;
  const float distance = std::sqrt(squared);
  const Vec3 w = to_light / distance;
  const BsdfEvaluation at_camera = camera_scattering.evaluate(w);
  if (is_black(at_camera.value)) return std::nullopt;
  const BsdfEvaluation at_light = light_scattering.evaluate(-w);
  if (is_black(at_light.value)) return std::nullopt;

  VertexConnection result;
  result.contribution = camera.throughput * at_camera.value * at_light.value * light.throughput /
                        squared * segment_transmittance(camera, w, distance);
  result.pdf_backward_camera = at_camera.pdf_reverse * camera.survival;
  result.pdf_backward_light = at_light.pdf_reverse * light.survival;
  result.pdf_scattering_camera = at_camera.pdf * camera.survival;
  result.pdf_arrival_light =
      at_camera.pdf * camera.survival * abs_cos_geometric(light, w) / squared;
  result.pdf_arrival_camera =
      at_light.pdf * light.survival * abs_cos_geometric(camera, w) / squared;
  result.shadow_ray = camera.point.spawn_ray_to(light.point);
  return result;
}

std::optional<LensConnection> connect_to_lens(const Camera& camera, const PathVertex& vertex,
                                              const Scattering& scattering, Vec2 u_lens) {
  const auto lens = camera.connect(vertex.point.position, u_lens);
  if (!lens) return std::nullopt;
  const BsdfEvaluation bsdf = scattering.evaluate(lens->direction);
  if (is_black(bsdf.value)) return std::nullopt;

  LensConnection result;
  const float squared = sqr(lens->distance);
  result.raster = lens->raster;
  result.distance = lens->distance;
  result.contribution = vertex.throughput * bsdf.value *
                        (lens->importance * lens->cos_camera / (squared * lens->pdf_lens)) *
                        segment_transmittance(vertex, lens->direction, lens->distance);
  const bool is_parallel = camera.description().model == CameraModel::Orthographic;
  result.pdf_arrival = lens->pdf_direction * abs_cos_geometric(vertex, lens->direction) /
                       (is_parallel ? 1.0f : squared);
  result.pdf_backward = bsdf.pdf_reverse * vertex.survival;
  // Nothing between the lens and the near clip stands in the way.
  const float clipped = camera.description().near_clip / lens->cos_camera;
  result.shadow_ray = vertex.point.spawn_ray_to(lens->lens_position - clipped * lens->direction);
  return result;
}

}  // namespace guidelight

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
                                                 Vec2 u_point) {
  const auto choice = scene.choose_light(u_light);
  if (!choice) return std::nullopt;
  const Light& light = *choice->light;
  const SurfacePoint& point = vertex.point;
  const auto sample = light.sample_direct(point.position, u_point);
  if (!sample || is_black(sample->radiance)) return std::nullopt;
  const Color value = scattering.value(sample->wi);
  if (is_black(value)) return std::nullopt;

  DirectConnection result;
  const float pdf = sample->pdf * choice->probability;
  result.contribution = vertex.throughput * value * sample->radiance / pdf *
                        segment_transmittance(vertex, sample->wi, sample->distance);
  result.pdf_backward = scattering.pdf_reverse(sample->wi) * vertex.survival;
  result.hit_ratio = light.is_delta() ? 0.0f : scattering.pdf(sample->wi) * vertex.survival / pdf;
  // Emission: position × direction, taken to the vertex by cosθ/d². Direct: pdf per solid angle,
  // taken to the light by cosθ_light/d². The squares cancel except where direct light has no
  // density to convert.
  result.emission_ratio = sample->pdf_position * sample->pdf_direction *
                          abs_cos_geometric(vertex, sample->wi) / (sample->pdf * sample->cos_light);
  if (light.is_delta_position()) result.emission_ratio /= sqr(sample->distance);
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
  const Color at_camera = camera_scattering.value(w);
  if (is_black(at_camera)) return std::nullopt;
  const Color at_light = light_scattering.value(-w);
  if (is_black(at_light)) return std::nullopt;

  VertexConnection result;
  result.contribution = camera.throughput * at_camera * at_light * light.throughput / squared *
                        segment_transmittance(camera, w, distance);
  result.pdf_backward_camera = camera_scattering.pdf_reverse(w) * camera.survival;
  result.pdf_backward_light = light_scattering.pdf_reverse(-w) * light.survival;
  result.pdf_arrival_light =
      camera_scattering.pdf(w) * camera.survival * abs_cos_geometric(light, w) / squared;
  result.pdf_arrival_camera =
      light_scattering.pdf(-w) * light.survival * abs_cos_geometric(camera, w) / squared;
  result.shadow_ray = camera.point.spawn_ray_to(light.point);
  return result;
}

std::optional<LensConnection> connect_to_lens(const Camera& camera, const PathVertex& vertex,
                                              const Scattering& scattering, Vec2 u_lens) {
  const auto lens = camera.connect(vertex.point.position, u_lens);
  if (!lens) return std::nullopt;
  const Color value = scattering.value(lens->direction);
  if (is_black(value)) return std::nullopt;

  LensConnection result;
  const float squared = sqr(lens->distance);
  result.raster = lens->raster;
  result.distance = lens->distance;
  result.contribution = vertex.throughput * value *
                        (lens->importance * lens->cos_camera / (squared * lens->pdf_lens)) *
                        segment_transmittance(vertex, lens->direction, lens->distance);
  const bool is_parallel = camera.description().model == CameraModel::Orthographic;
  result.pdf_arrival = lens->pdf_direction * abs_cos_geometric(vertex, lens->direction) /
                       (is_parallel ? 1.0f : squared);
  result.pdf_backward = scattering.pdf_reverse(lens->direction) * vertex.survival;
  // Nothing between the lens and the near clip stands in the way.
  const float clipped = camera.description().near_clip / lens->cos_camera;
  result.shadow_ray = vertex.point.spawn_ray_to(lens->lens_position - clipped * lens->direction);
  return result;
}

}  // namespace guidelight

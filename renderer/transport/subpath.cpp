#include "renderer/transport/subpath.h"

namespace guidelight {

std::optional<Subpath> start_light_path(const Scene& scene, Rng rng, float emission_count,
                                        EmissionSample& emission) {
  const auto choice = scene.choose_light(rng.next_float());
  if (!choice) return std::nullopt;
  const Vec2 u_position = rng.next_vec2();
  const auto sample = choice->light->sample_emission(u_position, rng.next_vec2());
  if (!sample || is_black(sample->weight)) return std::nullopt;
  emission = *sample;

  std::optional<Subpath> result(std::in_place);
  Subpath& path = *result;
  const Light& light = *choice->light;
  path.rng = rng;
  path.ray = emission.ray;
  path.origin = emission.ray.origin;
  path.throughput = emission.weight / choice->probability;
  path.cos_origin = emission.cos_light;
  path.light = &light;
  path.emission = &emission;
  // At infinity the direction is drawn first and stands for the point on the light; the position
  // across the rays is what the first vertex is drawn by.
  path.is_parallel = light.is_infinite();
  path.pdf = path.is_parallel ? emission.pdf_position : emission.pdf_direction;
  const float pdf_light =
      choice->probability * (path.is_parallel ? emission.pdf_direction : emission.pdf_position);
  path.sums.connection = light.is_delta() ? 0.0f : emission_count / pdf_light;
  const SurfacePoint& point = emission.point;
  path.medium = point.is_medium_boundary ? point.exterior : nullptr;
  return result;
}

}  // namespace guidelight

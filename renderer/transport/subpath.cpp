#include "renderer/transport/subpath.h"

#include "renderer/transport/guided_walk.h"

namespace guidelight {

namespace {

/// Fills `emission`. Null where nothing is emitted.
const Light* draw_emission(const Scene& scene, Rng& rng, GuidedWalk* guided,
                           EmissionSample& emission) {
  if (guided) {
    const GuidedWalk::Choice choice = guided->begin(rng);
    if (choice.is_guided) {
      if (!choice.start) return nullptr;
      emission = choice.start->emission;
      return choice.start->light;
    }
  }
  const auto choice = scene.choose_light(rng.next_float());
  if (!choice) return nullptr;
  const Vec2 u_position = rng.next_vec2();
  const auto sample = choice->light->sample_emission(u_position, rng.next_vec2());
  if (!sample || is_black(sample->weight)) return nullptr;
  emission = *sample;
  return choice->light;
}

}  // namespace

std::optional<Subpath> start_light_path(const Scene& scene, Rng rng, float emission_count,
                                        EmissionSample& emission, GuidedWalk* guided) {
  const Light* found = draw_emission(scene, rng, guided, emission);
  if (!found) return std::nullopt;
  const Light& light = *found;
  const float probability = scene.light_probability(light);
  if (!(probability > 0)) return std::nullopt;  // of a guide to a light that is never chosen
  const double pdf = double{probability} * emission.pdf_position * emission.pdf_direction;
  const float guided_ratio = guided ? guided->emit(light, emission, pdf) : 1.0f;

  std::optional<Subpath> result(std::in_place);
  Subpath& path = *result;
  path.rng = rng;
  path.ray = emission.ray;
  path.origin = emission.ray.origin;
  path.throughput = emission.weight / (probability * guided_ratio);
  path.cos_origin = emission.cos_light;
  path.light = &light;
  path.emission = &emission;
  path.guided = guided;
  // At infinity the direction is drawn first and stands for the point on the light; the position
  // across the rays is what the first vertex is drawn by.
  path.is_parallel = light.is_infinite();
  path.pdf = (path.is_parallel ? emission.pdf_position : emission.pdf_direction) * guided_ratio;
  const float pdf_light =
      probability * (path.is_parallel ? emission.pdf_direction : emission.pdf_position);
  path.sums.connection = light.is_delta() ? 0.0f : emission_count / pdf_light;
  const SurfacePoint& point = emission.point;
  path.medium = point.is_medium_boundary ? point.exterior : nullptr;
  return result;
}

}  // namespace guidelight

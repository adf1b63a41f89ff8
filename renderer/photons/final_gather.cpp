#include "renderer/photons/final_gather.h"

#include <limits>

namespace guidelight {

bool GatheredLight::serves(int vertex_length) const {
  if (!irradiance || settings.min_length > vertex_length + 1) return false;
  return vertex_length == 2 || settings.max_length == std::numeric_limits<int>::max();
}

Color GatheredLight::radiance(const PathVertex& vertex, const Scattering& scattering) const {
  // Precomputed irradiance is that of the true surface; a tilted shading normal weighs it
  // otherwise.
  constexpr float kUntilted = 0.9999f;
  const SurfacePoint& point = vertex.point;
  const bool is_tilted = glm::dot(point.frame.n, point.geometric_normal) < kUntilted;
  if (serves(vertex.length) && !is_tilted) {
    if (const auto value = lambertian_value(vertex, scattering)) {
      if (is_black(*value)) return Color(0.0f);
      const Vec3 outside = vertex.point.geometric_normal;
      const Vec3 normal = glm::dot(outside, vertex.wo) < 0 ? -outside : outside;
      const auto ready =
          irradiance->irradiance(vertex.point.position, normal, settings.max_distance);
      if (ready) return *value * *ready;
    }
  }
  return photons->radiance(vertex, scattering, settings);
}

FinalGather::FinalGather(const Scene& scene, const GatheredLight& light)
    : light_(light), walk_(scene, TransportMode::Radiance) {}

void FinalGather::add_ray(const PathVertex& vertex, Vec3 direction, Color weight, Rng rng) {
  Subpath& path = paths_.emplace_back();
  path.rng = rng;
  path.ray = vertex.point.spawn_ray(direction);
  path.origin = vertex.point.position;
  path.throughput = weight;
  path.pdf = 1;  // nothing asks for it
  path.medium = medium_beyond(vertex.point, direction, vertex.medium);
  path.length = vertex.length;
  samples_.emplace_back();
}

IrradianceRecord FinalGather::irradiance(const PathVertex& vertex, int rays, Rng rng) {
  clear();
  strata_.clear();
  first_length_ = vertex.length + 1;
  const Vec3 normal = normal_towards_viewer(vertex);
  Hemisphere hemisphere(vertex.point.position, normal, rays);
  const uint64_t seed = rng.next_uint();
  for (uint32_t i = 0; i < hemisphere.size(); ++i) {
    const Vec3 w = hemisphere.direction(i, rng.next_vec2());
    // Directions above the shading normal's horizon and below the surface's see nothing.
    if (glm::dot(w, vertex.point.geometric_normal) *
            glm::dot(normal, vertex.point.geometric_normal) <=
        0)
      continue;
    add_ray(vertex, w, Color(1.0f), Rng(seed, 0, i));
    strata_.push_back(i);
  }
  walk_.run(paths_, *this);
  for (size_t i = 0; i < paths_.size(); ++i) hemisphere[strata_[i]] = samples_[i];
  return hemisphere.record();
}

Color FinalGather::radiance(const PathVertex& vertex, const Scattering& scattering, int rays,
                            Rng rng) {
  clear();
  first_length_ = vertex.length + 1;
  const int side = std::max(1, static_cast<int>(std::lround(std::sqrt(static_cast<float>(rays)))));
  const float width = 1 / static_cast<float>(side);
  const uint64_t seed = rng.next_uint();
  for (int i = 0; i < side * side; ++i) {
    const float u_lobe = rng.next_float();
    const Vec2 u = (Vec2(i % side, i / side) + rng.next_vec2()) * width;
    const auto sample = scattering.sample(u_lobe, glm::min(u, Vec2(kOneMinusEpsilon)));
    const bool is_diffuse =
        sample && !sample->is_delta() && !light_.settings.sharp(vertex, scattering, sample->wi);
    if (is_diffuse) add_ray(vertex, sample->wi, sample->weight, Rng(seed, 1, i));
  }
  walk_.run(paths_, *this);
  Color sum(0.0f);
  for (const Hemisphere::Sample& sample : samples_) sum += sample.radiance;
  return sum * sqr(width);
}

bool FinalGather::visit(uint32_t index, Subpath& path, const PathVertex& vertex,
                        const Scattering& scattering) {
  Hemisphere::Sample& sample = samples_[index];
  if (vertex.length == first_length_) {
    sample.distance = vertex.hit.t;
  } else if (!light_.settings.sharp.at_origin(path)) {
    return false;  // the vertex before has read this light already
  }
  if (vertex.length >= light_.settings.max_length) return false;
  if (vertex.is_connectible()) {
    sample.radiance += vertex.throughput * light_.radiance(vertex, scattering);
  }
  return SharpScattering::is_possible(*vertex.point.bsdf);
}

}  // namespace guidelight

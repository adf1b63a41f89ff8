#include "renderer/transport/ray_footprint.h"

#include <algorithm>

namespace guidelight {

namespace {

/// At a focus the beam has no width, at a silhouette no end.
constexpr float kLargestChange = 8;

}  // namespace

RayFootprint::RayFootprint(Vec3 direction, bool is_parallel) : is_parallel_(is_parallel) {
  const Frame frame = Frame::from_normal(direction);
  const Vec3 across[2] = {frame.s, frame.t};
  for (int i = 0; i < 2; ++i) {
    position_[i] = is_parallel ? across[i] : Vec3(0);
    direction_[i] = is_parallel ? Vec3(0) : across[i];
  }
}

void RayFootprint::arrive(const Scene& scene, Vec3 origin, const PathVertex& vertex) {
  const SurfacePoint& point = vertex.point;
  const Vec3 direction = -vertex.wo;
  if (is_on_surface_) scatter(scene, direction);
  is_on_surface_ = true;

  const float distance = glm::distance(origin, point.position);
  for (int i = 0; i < 2; ++i) position_[i] += distance * direction_[i];
  length_ += distance;
  const float area = std::abs(glm::dot(direction, glm::cross(position_[0], position_[1])));
  const float unchanged = is_parallel_ ? 1.0f : length_;
  spread_ = std::clamp(std::sqrt(area), unchanged / kLargestChange, unchanged * kLargestChange);

  // Onto the surface, along the ray: Igehy 1999, (10) to (12).
  const Vec3 n = point.geometric_normal;
  for (Vec3& p : position_) p -= direction * (glm::dot(p, n) / glm::dot(direction, n));
  const float eta = point.bsdf->eta();  // inside over outside
  const Vec3 normal = point.frame.n;
  surface_ = {vertex.hit, point.position, normal, glm::dot(vertex.wo, normal) > 0 ? 1 / eta : eta,
              direction};
}

void RayFootprint::scatter(const Scene& scene, Vec3 direction) {
  const Vec3 before = surface_.direction;
  if (length_squared(direction - before) < 1e-10f) return;  // a straight pass
  const Vec3 n = surface_.normal;
  const float cos_before = glm::dot(before, n);
  const float cos_after = glm::dot(direction, n);
  const bool is_reflection = cos_before * cos_after < 0;
  const float eta = surface_.eta;
  for (int i = 0; i < 2; ++i) {
    const Vec3 dn = scene.normal_derivative(surface_.hit, surface_.position, n, position_[i]);
    const float change = glm::dot(direction_[i], n) + glm::dot(before, dn);  // of cos_before
    if (is_reflection) {
      direction_[i] -= 2.0f * (cos_before * dn + change * n);  // (15)
    } else {
      const float mu = eta * cos_before - cos_after;
      const float mu_change = (eta - sqr(eta) * cos_before / cos_after) * change;
      direction_[i] = eta * direction_[i] - (mu * dn + mu_change * n);  // (17) to (19)
    }
  }
}

}  // namespace guidelight

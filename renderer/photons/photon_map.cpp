#include "renderer/photons/photon_map.h"

#include <algorithm>

namespace guidelight {

namespace {

constexpr int kPhotonsPerPoint = 4;
/// An estimate of irradiance searches more photons than k, because it leaves a share of them out.
constexpr float kOversearch = kPhotonsPerPoint / (kPhotonsPerPoint - 1.0f);

using Buffer = std::array<Neighbor, 2 * EstimateSettings::kMaxNeighbors>;

}  // namespace

SurfacePhoton make_surface_photon(const PathVertex& vertex, Color power, bool caustic) {
  const Vec3 normal = vertex.point.geometric_normal;
  SurfacePhoton photon;
  static_cast<Photon&>(photon) =
      make_photon(vertex.point.position, vertex.wo, power, vertex.length, caustic);
  photon.packed_normal = pack_direction(glm::dot(normal, vertex.wo) < 0 ? -normal : normal);
  return photon;
}

bool is_irradiance_point(const SurfacePhoton& photon) {
  // The hash of its place: chance, but the same chance whenever it is asked.
  return (hash_position(photon.position) >> 56) % kPhotonsPerPoint == 0;
}

Color PhotonMap::radiance(const PathVertex& vertex, const Scattering& scattering,
                          const EstimateSettings& settings) const {
  const SurfacePoint& point = vertex.point;
  Buffer buffer;
  const Neighbors neighbors =
      settings.oversearch > 1
          ? nearest_on_surface(point, settings, buffer)
          : tree_.nearest(point.position, settings.neighbors, settings.max_distance, buffer);
  Color sum(0.0f);
  float squares = 0;
  for (const Neighbor& neighbor : neighbors.found) {
    const SurfacePhoton& photon = tree_.items()[neighbor.index];
    const int length = vertex.length + photon.length();
    if (length < settings.min_length || length > settings.max_length) continue;
    if (!is_same_surface(photon.normal(), point.geometric_normal)) continue;
    const Vec3 wi = photon.direction();
    const Color value = scattering.value(wi);
    if (is_black(value) || settings.sharp(vertex, scattering, wi)) continue;
    // The flux arrived through the true surface where the photon is: the cosine there is part of
    // it. Another's, of a surface that is curved, may be anything down to 0.
    const float cosine = std::abs(glm::dot(wi, photon.normal()));
    if (cosine == 0) continue;
    const Color contribution =
        value * photon.power() *
        (kernel_value(settings.kernel, neighbor.distance_squared, neighbors.radius_squared) /
         cosine);
    sum += contribution;
    if (settings.min_effective > 0) squares += sqr(luminance(contribution));
  }
  const bool is_certain = sqr(luminance(sum)) >= settings.min_effective * squares;
  return is_certain ? sum : Color(0.0f);
}

Neighbors PhotonMap::nearest_on_surface(const SurfacePoint& point, const EstimateSettings& settings,
                                        std::span<Neighbor> buffer) const {
  const size_t k = settings.neighbors;
  const size_t most = std::min(k * settings.oversearch, buffer.size());
  const auto begin = buffer.begin();
  Neighbors result;
  size_t count = 0;
  // Most points have no other surface near.
  for (size_t searched = k;; searched = most) {
    result = tree_.nearest(point.position, searched, settings.max_distance, buffer);
    const auto end = std::partition(begin, begin + result.found.size(), [&](const Neighbor& n) {
      return is_same_surface(tree_.items()[n.index].normal(), point.geometric_normal);
    });
    count = static_cast<size_t>(end - begin);
    if (count >= k || result.found.size() < searched || searched == most) break;
  }
  if (count < k) return {};
  const auto end = begin + static_cast<ptrdiff_t>(count);
  std::nth_element(begin, begin + (k - 1), end, [](const Neighbor& a, const Neighbor& b) {
    return a.distance_squared < b.distance_squared;
  });
  return {buffer.first(k), buffer[k - 1].distance_squared};
}

PhotonMap::Irradiance PhotonMap::irradiance(Vec3 position, Vec3 normal,
                                            const EstimateSettings& settings,
                                            int max_length) const {
  const float k = static_cast<float>(settings.neighbors) * kOversearch;
  Buffer buffer;
  const Neighbors neighbors =
      tree_.nearest(position, static_cast<size_t>(k), settings.max_distance, buffer);
  Color sum(0.0f);
  for (const Neighbor& neighbor : neighbors.found) {
    const SurfacePhoton& photon = tree_.items()[neighbor.index];
    if (photon.length() > max_length || is_irradiance_point(photon)) continue;
    if (!is_same_side(photon.normal(), normal)) continue;
    sum += photon.power() *
           kernel_value(settings.kernel, neighbor.distance_squared, neighbors.radius_squared);
  }
  return {sum * kOversearch, neighbors.radius_squared};
}

namespace {

/// Whether two points lie in one plane, but for what a smooth surface is curved.
bool is_in_plane(Vec3 from_one_to_other, Vec3 normal) {
  constexpr float kSine = 0.1f;
  return sqr(glm::dot(from_one_to_other, normal)) <= sqr(kSine) * length_squared(from_one_to_other);
}

}  // namespace

IrradianceMap::IrradianceMap(const PhotonMap& photons, const EstimateSettings& settings,
                             int max_length, Parallel& parallel) {
  constexpr size_t kPointsPerTask = 256;
  std::vector<Point> points;
  for (const SurfacePhoton& photon : photons.photons()) {
    if (!is_irradiance_point(photon)) continue;
    points.push_back({photon.position, photon.packed_normal, Color(0.0f), 0});
  }
  // The disc of an estimate of k photons holds k/4 points, and k lie within twice its radius: so
  // one is in reach nearly always. With less, bright estimates, whose discs are small, would be
  // those that are not found.
  constexpr float kReach = 2;
  parallel.for_each((points.size() + kPointsPerTask - 1) / kPointsPerTask, [&](size_t task) {
    const size_t end = std::min(points.size(), (task + 1) * kPointsPerTask);
    for (size_t i = task * kPointsPerTask; i < end; ++i) {
      Point& point = points[i];
      const auto estimate = photons.irradiance(
          point.position, unpack_direction(point.packed_normal), settings, max_length);
      point.irradiance = estimate.value;
      point.reach_squared = sqr(kReach) * estimate.radius_squared;
    }
  });
  tree_ = KdTree<Point>(points, parallel);
}

std::optional<Color> IrradianceMap::irradiance(Vec3 position, Vec3 normal,
                                               float max_distance) const {
  // Near an edge, the nearest points may belong to another surface.
  std::array<Neighbor, 4> buffer;
  const Neighbors neighbors = tree_.nearest(position, buffer.size(), max_distance, buffer);
  const Point* best = nullptr;
  float best_distance = kInfinity;
  for (const Neighbor& neighbor : neighbors.found) {
    const Point& point = tree_.items()[neighbor.index];
    const bool in_reach = neighbor.distance_squared <= point.reach_squared ||
                          is_in_plane(point.position - position, normal);
    const bool fits = in_reach && is_same_side(unpack_direction(point.packed_normal), normal);
    if (!fits || neighbor.distance_squared >= best_distance) continue;
    best = &point;
    best_distance = neighbor.distance_squared;
  }
  if (!best) return std::nullopt;
  return best->irradiance;
}

std::optional<Color> lambertian_value(const PathVertex& vertex, const Scattering& scattering) {
  if (vertex.point.bsdf->lobes() != kLobeDiffuse) return std::nullopt;
  const Vec3 normal = normal_towards_viewer(vertex);
  const Vec3 oblique = normal + vertex.point.frame.s;
  const Color value = scattering.value(normal);
  const Color other = scattering.value(glm::normalize(oblique));
  const float difference = max_component(glm::abs(value - other * glm::length(oblique)));
  if (difference > 1e-3f * max_component(value)) return std::nullopt;
  return value;
}

}  // namespace guidelight

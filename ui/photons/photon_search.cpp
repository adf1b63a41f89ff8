#include "ui/photons/photon_search.h"

#include <algorithm>

namespace guidelight {
namespace {

constexpr size_t kSearched = 64;     // nearest photons of any surface …
constexpr size_t kCounted = 24;      // … of which so many of this one make an estimate
constexpr float kOffSurface = 0.2f;  // photons this steep above the plane lie on another surface

}  // namespace

PhotonSearch::PhotonSearch(const PhotonCloud& cloud, float max_distance, Parallel& parallel)
    : tree_(cloud.points, parallel),
      max_distance_(max_distance),
      photons_per_point_(static_cast<float>(cloud.total) /
                         static_cast<float>(std::max<size_t>(1, cloud.points.size()))) {}

float PhotonSearch::density(Vec3 position, Vec3 normal) const {
  std::array<Neighbor, kSearched> buffer;
  const Neighbors all = tree_.nearest(position, kSearched, max_distance_, buffer);
  const auto elsewhere = [&](const Neighbor& neighbor) {
    const Vec3 way = tree_.items()[neighbor.index].position - position;
    return std::abs(glm::dot(way, normal)) > kOffSurface * std::sqrt(neighbor.distance_squared);
  };
  const auto begin = buffer.begin();
  const auto end = std::remove_if(begin, begin + all.found.size(), elsewhere);
  const auto count = static_cast<size_t>(end - begin);
  if (count < kCounted) {
    return photons_per_point_ * static_cast<float>(count) / (kPi * all.radius_squared);
  }
  std::nth_element(begin, begin + (kCounted - 1), end, [](const Neighbor& a, const Neighbor& b) {
    return a.distance_squared < b.distance_squared;
  });
  // The farthest marks the rim: the mean of (k-1)/r² is the density itself.
  return photons_per_point_ * (kCounted - 1) / (kPi * buffer[kCounted - 1].distance_squared);
}

std::optional<float> PhotonSearch::radius_of(float count, Vec3 position, Vec3 normal) const {
  const float around = density(position, normal);
  if (!(around > 0)) return std::nullopt;
  return std::sqrt(count / (kPi * around));
}

}  // namespace guidelight

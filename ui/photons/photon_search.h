#pragma once

#include <memory>

#include "renderer/photons/kd_tree.h"
#include "renderer/photons/photon_cloud.h"

namespace guidelight {

/// Finds the photons around a place on a surface, as far as they are shown, and says what they
/// stand for: all photons of their pass.
class PhotonSearch {
 public:
  /// Nothing farther than `max_distance` is looked for.
  PhotonSearch(const PhotonCloud& cloud, float max_distance, Parallel& parallel);

  /// Photons of the pass per area of the surface, from the nearest ones [1/scene unit²].
  float density(Vec3 position, Vec3 normal) const;
  /// Radius of the disc that holds `count` photons of the pass, by their density; empty where there
  /// are none.
  std::optional<float> radius_of(float count, Vec3 position, Vec3 normal) const;

 private:
  KdTree<PhotonCloud::Point> tree_;
  float max_distance_;
  float photons_per_point_;  // of the pass, for each that is shown
};

}  // namespace guidelight

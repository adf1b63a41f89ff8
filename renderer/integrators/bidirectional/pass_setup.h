#pragma once

#include <cmath>

#include "renderer/image/film.h"
#include "renderer/integrators/bidirectional/settings.h"
#include "renderer/transport/mis.h"

namespace guidelight {

/// The merging radius of one pass. It belongs to a full path: from the scene's size it is the same
/// for all, from the pixel's footprint it depends on how far light travels from the camera to the
/// first vertex that is not specular. Every technique can find that out, so the weights still sum
/// to 1.
class MergingRadius {
 public:
  MergingRadius(const Scene& scene, const BidirectionalSettings& settings, uint32_t pass,
                size_t light_paths)
      : light_paths_(settings.merges() ? static_cast<float>(light_paths) : 0.0f) {
    // Knaus and Zwicker 2011, (15), for any α.
    const float shrink = std::pow(static_cast<float>(pass) + 1, 0.5f * (settings.alpha - 1));
    const Camera& camera = scene.camera();
    if (settings.radius_from == 0) {
      constant_ = shrink * 0.01f * settings.scene_radius * scene.bounds().radius();
    } else {
      const float pixel = shrink * settings.pixel_radius * camera.pixel_size_at_unit_distance();
      const bool is_parallel = camera.description().model == CameraModel::Orthographic;
      (is_parallel ? constant_ : per_distance_) = pixel;
    }
    typical_ = at(glm::distance(scene.bounds().center(), camera.position()));
  }

  /// `distance`: length of the camera path up to its first vertex that is not specular.
  float at(float distance) const { return constant_ + per_distance_ * distance; }
  /// Light paths merged with × merging area.
  float eta(float radius) const { return light_paths_ * kPi * sqr(radius); }
  float typical() const { return typical_; }

 private:
  float light_paths_;
  float constant_ = 0;
  float per_distance_ = 0;
  float typical_;
};

/// What the stages of one pass share.
struct PassSetup {
  /// `vertices_per_light_path`: about how many of a light path can be connected; matters where
  /// random ones of all are chosen.
  PassSetup(const Scene& the_scene, const BidirectionalSettings& the_settings, uint32_t the_pass,
            uint64_t the_seed, size_t pixels, float vertices_per_light_path = 1);

  const Scene& scene;
  const BidirectionalSettings& settings;
  uint32_t pass;
  uint64_t seed;
  size_t light_path_count;
  MergingRadius radius;
  MisWeights weights;

  /// Paths may have this many segments.
  bool is_shown(int length) const { return length >= settings.min_length && length <= max_length; }
  int max_length;
};

}  // namespace guidelight

#pragma once

#include "renderer/image/film.h"
#include "renderer/integrators/bidirectional/settings.h"
#include "renderer/integrators/search_radius.h"
#include "renderer/transport/mis.h"

namespace guidelight {

/// About how many vertices of a light path can be connected or merged with. Weights may only depend
/// on what is known before a pass, so this is not counted in it.
struct LightPathStatistics {
  float vertices = 1;
};

/// The merging radius of one pass. It belongs to a full path: from the scene's size it is the same
/// for all, from the pixel's footprint it depends on the way from the camera to the first vertex
/// that is not specular. Every technique can find that out, so the weights still sum
/// to 1.
class MergingRadius {
 public:
  MergingRadius(const Scene& scene, const BidirectionalSettings& settings, uint32_t pass,
                size_t light_paths, const LightPathStatistics& statistics);

  /// As of SearchRadius. For the k nearest photons this is only the longest distance.
  float at(const RayFootprint* footprint) const { return shrink_ * initial_.at(footprint); }
  float seen_directly(const Camera& camera, float distance) const {
    return shrink_ * initial_.seen_directly(camera, distance);
  }
  bool needs_footprint() const { return initial_.needs_footprint(); }
  /// Light paths merged with × merging area, for the weights. For the k nearest photons, whose
  /// area is not known to other techniques, it is that of photons spread evenly over the scene:
  /// weights sum to 1 with any value.
  float eta(float radius) const {
    return merges_nearest_ ? eta_of_nearest_ : light_paths_ * kPi * sqr(radius);
  }
  float typical() const { return shrink_ * initial_.typical(); }

 private:
  SearchRadius initial_;
  float light_paths_;
  float shrink_;
  bool merges_nearest_;
  float eta_of_nearest_ = 0;
};

/// What the stages of one pass share.
struct PassSetup {
  PassSetup(const Scene& the_scene, const BidirectionalSettings& the_settings, uint32_t the_pass,
            uint64_t the_seed, size_t pixels, const LightPathStatistics& statistics = {});

  const Scene& scene;
  const BidirectionalSettings& settings;
  TechniqueImages* techniques = nullptr;  // if somebody wants to see them
  std::optional<GuidedEmission> guided;   // if light paths follow guides
  uint32_t pass;
  uint64_t seed;
  size_t light_path_count;
  MergingRadius radius;
  MisWeights weights;

  /// Paths may have this many segments.
  bool is_shown(int length) const { return length >= settings.min_length && length <= max_length; }
  int max_length;
  const GuidedEmission* guided_emission() const { return guided ? &*guided : nullptr; }
};

}  // namespace guidelight

#pragma once

#include <cmath>

#include "renderer/image/film.h"
#include "renderer/integrators/bidirectional/settings.h"
#include "renderer/integrators/search_radius.h"
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
      : initial_(scene, settings),
        light_paths_(settings.merges() ? static_cast<float>(light_paths) : 0.0f),
        // Knaus and Zwicker 2011, (15), for any α.
        shrink_(std::pow(static_cast<float>(pass) + 1, 0.5f * (settings.alpha - 1))) {}

  /// `distance`: length of the camera path up to its first vertex that is not specular.
  float at(float distance) const { return shrink_ * initial_.at(distance); }
  /// Light paths merged with × merging area.
  float eta(float radius) const { return light_paths_ * kPi * sqr(radius); }
  float typical() const { return shrink_ * initial_.typical(); }

 private:
  SearchRadius initial_;
  float light_paths_;
  float shrink_;
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

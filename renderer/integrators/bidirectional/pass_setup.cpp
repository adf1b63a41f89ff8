#include "renderer/integrators/bidirectional/pass_setup.h"

#include <algorithm>
#include <limits>

namespace guidelight {

namespace {

TechniqueCounts technique_counts(const BidirectionalSettings& settings, size_t light_paths,
                                 size_t pixels, float vertices_per_light_path) {
  TechniqueCounts counts;
  counts.emission = settings.emission ? 1.0f : 0.0f;
  counts.next_event = settings.next_event ? 1.0f : 0.0f;
  counts.light_tracing =
      settings.light_tracing ? static_cast<float>(light_paths) / static_cast<float>(pixels) : 0.0f;
  counts.connections = settings.connections ? 1.0f : 0.0f;
  if (settings.connects_to_random_vertices()) {
    counts.connections = static_cast<float>(settings.random_vertices) / vertices_per_light_path;
  }
  counts.merging = settings.merges() ? static_cast<float>(light_paths) : 0.0f;
  counts.merge_direct = settings.merge_direct;
  return counts;
}

}  // namespace

PassSetup::PassSetup(const Scene& the_scene, const BidirectionalSettings& the_settings,
                     uint32_t the_pass, uint64_t the_seed, size_t pixels,
                     float vertices_per_light_path)
    : scene(the_scene),
      settings(the_settings),
      pass(the_pass),
      seed(the_seed),
      light_path_count(std::max<size_t>(
          1, static_cast<size_t>(std::llround(static_cast<double>(settings.light_paths) *
                                              static_cast<double>(pixels))))),
      radius(scene, settings, pass, light_path_count),
      weights(technique_counts(settings, light_path_count, pixels, vertices_per_light_path)),
      max_length(settings.max_length < 0 ? std::numeric_limits<int>::max() / 2
                                         : settings.max_length) {}

}  // namespace guidelight

#include "renderer/integrators/bidirectional/pass_setup.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace guidelight {

namespace {

/// Of VCM [sr], measured in docs/mis.md.
constexpr float kIndependentAngle = 0.03f;

TechniqueCounts technique_counts(const BidirectionalSettings& settings, size_t light_paths,
                                 size_t pixels, const LightPathStatistics& statistics) {
  TechniqueCounts counts;
  counts.emission = settings.emission ? 1.0f : 0.0f;
  counts.next_event = settings.next_event ? 1.0f : 0.0f;
  counts.light_tracing =
      settings.light_tracing ? static_cast<float>(light_paths) / static_cast<float>(pixels) : 0.0f;
  counts.connections = settings.connections ? 1.0f : 0.0f;
  if (settings.connects_to_random_vertices()) {
    counts.connections = static_cast<float>(settings.random_vertices) / statistics.vertices;
  }
  counts.merging = settings.merges() ? static_cast<float>(light_paths) : 0.0f;
  counts.merge_direct = settings.merge_direct;
  if (settings.kind == BidirectionalKind::Vcm) counts.independent_angle = kIndependentAngle;
  return counts;
}

}  // namespace

MergingRadius::MergingRadius(const Scene& scene, const BidirectionalSettings& settings,
                             uint32_t pass, size_t light_paths,
                             const LightPathStatistics& statistics)
    : initial_(scene, settings),
      light_paths_(settings.merges() ? static_cast<float>(light_paths) : 0.0f),
      // Knaus and Zwicker 2011, (15), for any α.
      shrink_(settings.merges_nearest()
                  ? 1.0f
                  : std::pow(static_cast<float>(pass) + 1, 0.5f * (settings.alpha - 1))),
      merges_nearest_(settings.merges_nearest()) {
  if (!merges_nearest_) return;
  const Vec3 size = scene.bounds().upper - scene.bounds().lower;
  const float surface = 2 * (size.x * size.y + size.y * size.z + size.z * size.x);
  // k photons of N·vertices over the surface fill the area k·surface / (N·vertices).
  eta_of_nearest_ = static_cast<float>(settings.neighbors) * surface / statistics.vertices;
}

PassSetup::PassSetup(const Scene& the_scene, const BidirectionalSettings& the_settings,
                     uint32_t the_pass, uint64_t the_seed, size_t pixels,
                     const LightPathStatistics& statistics)
    : scene(the_scene),
      settings(the_settings),
      pass(the_pass),
      seed(the_seed),
      light_path_count(std::max<size_t>(
          1, static_cast<size_t>(std::llround(static_cast<double>(settings.light_paths) *
                                              static_cast<double>(pixels))))),
      radius(scene, settings, pass, light_path_count, statistics),
      weights(technique_counts(settings, light_path_count, pixels, statistics)),
      max_length(settings.max_length < 0 ? std::numeric_limits<int>::max() / 2
                                         : settings.max_length) {}

}  // namespace guidelight

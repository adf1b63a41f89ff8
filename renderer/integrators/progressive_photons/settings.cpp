#include "renderer/integrators/progressive_photons/settings.h"

namespace guidelight {

std::vector<Parameter> ProgressivePhotonSettings::parameters() {
  std::vector<Parameter> list = {
      {"max_length", "Longest path", "Longest path in segments, -1 has no limit.", "segments",
       &max_length, -1, 1024},
      {"min_length", "Shortest path",
       "Shortest path in segments: 1 shows emitters, 2 begins with direct light.", "segments",
       &min_length, 1, 1024},
      {"light_paths", "Light paths", "Light paths per pixel and pass.", "per pixel", &light_paths,
       0.01, 100, true},
      guide_parameter(),
      {"alpha", "Kept photons",
       "Share of each pass's photons that counts; the radius shrinks to make room for it. 1 keeps "
       "the radius.",
       "", &alpha, 0.01, 1},
  };
  for (const Parameter& parameter : radius_parameters()) list.push_back(parameter);
  if (kind == ProgressivePhotonKind::Ppm) {
    list.push_back({"points", "Points", "Points of measurement per pixel, against jagged edges.",
                    "per pixel", &points, 1, 64});
  }
  return list;
}

std::unique_ptr<IntegratorSettings> ProgressivePhotonSettings::clone() const {
  return std::make_unique<ProgressivePhotonSettings>(*this);
}

}  // namespace guidelight

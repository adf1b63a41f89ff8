#include "renderer/integrators/photon_mapping/settings.h"

#include <algorithm>
#include <limits>

namespace guidelight {

std::vector<Parameter> PhotonMappingSettings::parameters() {
  return {
      {"light_paths", "Light paths", "Light paths per pass; each leaves several photons.", "",
       &light_paths, 1, 100e6, true},
      guide_parameter(),
      {"max_length", "Longest path", "Longest path in segments, -1 has no limit.", "segments",
       &max_length, -1, 1024},
      {"min_length", "Shortest path",
       "Shortest path in segments: 1 shows emitters, 2 begins with direct light.", "segments",
       &min_length, 1, 1024},
      {"neighbors", "Photons", "Nearest photons that an estimate is made of.", "per estimate",
       &neighbors, 2, static_cast<double>(EstimateSettings::kMaxNeighbors), true},
      {"global_distance", "Largest radius",
       "Of an estimate from the global map, in percent of that of the scene's bounding sphere.",
       "% of scene", &global_distance, 0, 100, true},
      {"caustic_distance", "Caustic radius",
       "Largest radius of an estimate from the caustic map, in percent of that of the scene's "
       "bounding sphere.",
       "% of scene", &caustic_distance, 0, 100, true},
      {"kernel", "Kernel", "How photons count between the centre of an estimate and its rim.", "",
       Parameter::Choice{&kernel, {"constant", "cone", "epanechnikov"}}},
      {"alpha", "Shrinking",
       "Pass i takes k*i^(alpha-1) photons from a radius r*i^((alpha-1)/2); 1 shrinks neither.", "",
       &alpha, 0.01, 1},
      {"camera_samples", "Camera samples",
       "Camera paths per pixel and pass, which share the pass's photons and cached light: edges "
       "and patterns of direct light cost little beside the gather.",
       "per pixel and pass", &camera_samples, 1, 256, true},
      {"gather_rays", "Gather rays",
       "Rays per point where indirect light is gathered; where nothing can be cached, per pixel.",
       "", &gather_rays, 1, 10000, true},
      {"light_samples", "Light samples",
       "Points on lights per vertex of a camera path: direct light costs little beside the gather.",
       "", &light_samples, 1, 1000, true},
      {"sharpness", "Sharp scattering",
       "Scattering of a higher density is followed like a mirror's, any other estimated from "
       "photons.",
       "per sr", &sharpness, 0.35, 1e6, true},
      {"precomputed_irradiance", "Precompute",
       "Computes irradiance ahead at every fourth photon; gather rays then look up one point "
       "instead of all photons of an estimate.",
       "", &precomputed_irradiance},
      {"irradiance_cache", "Irradiance cache",
       "Gathers at few points and interpolates by gradients, on surfaces that reflect light "
       "evenly.",
       "", &irradiance_cache},
      {"cache_accuracy", "Cache accuracy",
       "Relative error that the cache's model allows: smaller means more points.", "",
       &cache_accuracy, 0.01, 1, true, irradiance_cache ? "" : "The irradiance cache is off."},
  };
}

std::unique_ptr<IntegratorSettings> PhotonMappingSettings::clone() const {
  return std::make_unique<PhotonMappingSettings>(*this);
}

PhotonMappingPass::PhotonMappingPass(const Scene& the_scene,
                                     const PhotonMappingSettings& the_settings, uint32_t the_pass,
                                     uint64_t the_seed)
    : scene(the_scene), settings(the_settings), pass(the_pass), seed(the_seed) {
  const float shrink = std::pow(static_cast<float>(pass) + 1, settings.alpha - 1);
  const float percent = 0.01f * scene.bounds().radius() * std::sqrt(shrink);
  // Fewer than 3 make an estimate whose variance has no bound.
  const float shrunk = std::max(3.0f, static_cast<float>(settings.neighbors) * shrink);
  global.neighbors = std::min(settings.neighbors, static_cast<int>(std::lround(shrunk)));
  global.max_distance = settings.global_distance * percent;
  global.kernel = static_cast<Kernel>(settings.kernel);
  global.min_length = settings.min_length;
  global.max_length =
      settings.max_length < 0 ? std::numeric_limits<int>::max() : settings.max_length;
  global.sharp = SharpScattering(settings.sharpness);
  caustic = global;
  caustic.max_distance = settings.caustic_distance * percent;
}

}  // namespace guidelight

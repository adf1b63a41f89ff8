#pragma once

#include "renderer/integrators/guide_settings.h"
#include "renderer/integrators/integrator.h"
#include "renderer/photons/photon_map.h"

namespace guidelight {

/// Settings of photon mapping. Distances are in percent of the radius of the scene's bounding
/// sphere.
struct PhotonMappingSettings : IntegratorSettings, GuideSettings {
  int light_paths = 100000;       // per pass
  int max_length = 12;            // segments, -1 has no limit
  int min_length = 1;             // segments
  int neighbors = 60;             // k
  float global_distance = 10;     // largest radius of an estimate from the global map
  float caustic_distance = 1.5f;  // the same of the caustic map
  int kernel = 1;                 // enum Kernel
  float alpha = 1;                // k of pass i is k·i^(α-1)
  int gather_rays = 100;          // per gather point
  int camera_samples = 4;         // camera paths per pixel and pass
  int light_samples = 4;          // points on lights, per vertex
  float sharpness = 2;            // see SharpScattering [1/sr]
  bool precomputed_irradiance = true;
  bool irradiance_cache = true;
  float cache_accuracy = 0.2f;

  std::vector<Parameter> parameters() override;
  std::unique_ptr<IntegratorSettings> clone() const override;
};

/// What the stages of one pass share.
struct PhotonMappingPass {
  PhotonMappingPass(const Scene& the_scene, const PhotonMappingSettings& the_settings,
                    uint32_t the_pass, uint64_t the_seed);

  const Scene& scene;
  const PhotonMappingSettings& settings;
  uint32_t pass;
  uint64_t seed;
  std::optional<GuidedEmission> guided;  // if light paths follow guides
  EstimateSettings global;               // how each map is read
  EstimateSettings caustic;

  bool is_shown(int length) const {
    return length >= global.min_length && length <= global.max_length;
  }
};

}  // namespace guidelight

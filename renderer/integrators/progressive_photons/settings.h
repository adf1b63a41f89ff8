#pragma once

#include "renderer/integrators/guide_settings.h"
#include "renderer/integrators/integrator.h"
#include "renderer/integrators/search_radius.h"

namespace guidelight {

/// Ppm: the points of measurement stay where they are (Hachisuka et al. 2008). Sppm: every pass has
/// new ones (Hachisuka and Jensen 2009).
enum class ProgressivePhotonKind { Ppm, Sppm };

struct ProgressivePhotonSettings : IntegratorSettings, RadiusSettings, GuideSettings {
  explicit ProgressivePhotonSettings(ProgressivePhotonKind which) : kind(which) {}

  ProgressivePhotonKind kind;
  int max_length = 12;     // segments
  int min_length = 1;      // segments
  float light_paths = 1;   // per pixel and pass
  float alpha = 2.0f / 3;  // share of the photons found that is kept, the rest pays for shrinking
  int points = 4;          // camera paths per pixel, PPM

  int paths_per_pixel() const { return kind == ProgressivePhotonKind::Ppm ? points : 1; }

  std::vector<Parameter> parameters() override;
  std::unique_ptr<IntegratorSettings> clone() const override;
};

}  // namespace guidelight

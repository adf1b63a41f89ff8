#pragma once

#include <optional>

#include "renderer/integrators/integrator.h"
#include "renderer/photons/photon_cloud.h"
#include "renderer/transport/guided_walk.h"

namespace guidelight {

/// Part of the settings of methods whose light paths can follow guides.
struct GuideSettings {
  float guided_fraction = 0.5f;

  Parameter guide_parameter() {
    return {"guided_fraction",
            "Guided paths",
            "Share of the light paths that follow guide paths, where there are any.",
            "",
            &guided_fraction,
            0,
            0.95};
  }

  /// Empty where no path follows a guide.
  std::optional<GuidedEmission> guided_emission(const PassContext& context) const {
    if (!context.guides || !(guided_fraction > 0)) return std::nullopt;
    return GuidedEmission{context.guides.get(), guided_fraction,
                          context.photons ? &context.photons->guided_places() : nullptr};
  }
};

}  // namespace guidelight

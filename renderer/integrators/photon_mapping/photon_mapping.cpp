#include "renderer/integrators/photon_mapping/photon_mapping.h"

#include "renderer/error.h"
#include "renderer/integrators/photon_mapping/emission_stage.h"
#include "renderer/integrators/photon_mapping/second_pass.h"

namespace guidelight {

namespace {

class PhotonMapping : public Integrator {
 public:
  PhotonMapping(std::shared_ptr<const Scene> scene, const PhotonMappingSettings& settings)
      : scene_(std::move(scene)), settings_(settings) {
    if (settings.global_distance == 0 || settings.caustic_distance == 0) {
      throw Error("a search distance of 0 finds no photons: give a larger one");
    }
  }

  void render_pass(uint32_t pass, Film& film, const PassContext& context) override {
    PhotonMappingPass setup(*scene_, settings_, pass, context.seed);
    setup.guided = settings_.guided_emission(context);
    show_photons(setup, EmissionStage::trace_all(setup, *context.parallel), film, context);
  }

 private:
  std::shared_ptr<const Scene> scene_;
  PhotonMappingSettings settings_;
};

std::unique_ptr<IntegratorSettings> photon_mapping_settings(const RenderHints& hints) {
  auto settings = std::make_unique<PhotonMappingSettings>();
  settings->max_length = hints.max_depth.value_or(settings->max_length);
  return settings;
}

std::unique_ptr<Integrator> create_photon_mapping(std::shared_ptr<const Scene> scene,
                                                  const IntegratorSettings& settings) {
  return std::make_unique<PhotonMapping>(std::move(scene),
                                         dynamic_cast<const PhotonMappingSettings&>(settings));
}

}  // namespace

IntegratorInfo photon_mapping_info() {
  return {"photon_map", "Photon mapping",
          "Two passes with final gather: smooth diffuse light and caustics early, blurred by a "
          "radius that more passes do not shrink.",
          photon_mapping_settings, create_photon_mapping};
}

}  // namespace guidelight

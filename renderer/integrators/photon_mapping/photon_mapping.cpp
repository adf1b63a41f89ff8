#include "renderer/integrators/photon_mapping/photon_mapping.h"

#include "renderer/error.h"
#include "renderer/integrators/photon_mapping/emission_stage.h"
#include "renderer/integrators/photon_mapping/gather_stage.h"
#include "renderer/photons/photon_cloud.h"

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
    PhotonMaps maps = make_maps(setup, *context.parallel);
    if (context.photons) {
      context.photons->collect(1, maps.global.photons(), maps.caustic.photons());
    }
    const GatheredLight light{
        .photons = &maps.global,
        .irradiance = settings_.precomputed_irradiance ? &maps.irradiance : nullptr,
        .settings = setup.global};
    if (settings_.irradiance_cache) fill_cache(setup, light, film, context, maps.cache);
    for_each_tile(film, context, [&](const Tile& tile) {
      GatherStage(setup, light, maps).render(tile.pixels, film);
    });
  }

 private:
  PhotonMaps make_maps(const PhotonMappingPass& setup, Parallel& parallel) const {
    const EmissionStage::Photons photons = EmissionStage::trace_all(setup, parallel);
    PhotonMaps maps{.global = PhotonMap(photons.global, parallel),
                    .caustic = PhotonMap(photons.caustic, parallel),
                    .irradiance = {},
                    .cache = make_cache(setup)};
    if (settings_.precomputed_irradiance) {
      // Rays that go from the first vertex straight to another one: two segments are theirs.
      maps.irradiance =
          IrradianceMap(maps.global, setup.global, setup.global.max_length - 2, parallel);
    }
    return maps;
  }

  /// Every tile finds its records alone; then all tiles share them, so that the picture shows no
  /// seams. The order of tiles, not of threads, is what the result depends on.
  void fill_cache(const PhotonMappingPass& setup, const GatheredLight& light, const Film& film,
                  const PassContext& context, IrradianceCache& cache) const {
    std::vector<std::vector<IrradianceRecord>> records(tile_count(film, context));
    for_each_tile(film, context, [&](const Tile& tile) {
      records[tile.index] = GatherPoints(setup, light).trace(tile.pixels, film.filter());
    });
    for (const auto& of_tile : records) {
      for (const IrradianceRecord& record : of_tile) cache.insert(record);
    }
  }

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

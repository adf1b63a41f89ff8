#include "renderer/integrators/photon_mapping/second_pass.h"

#include "renderer/integrators/photon_mapping/gather_stage.h"
#include "renderer/photons/photon_cloud.h"

namespace guidelight {

namespace {

PhotonMaps make_maps(const PhotonMappingPass& setup, const PassPhotons& photons,
                     Parallel& parallel) {
  PhotonMaps maps{.global = PhotonMap(photons.global, parallel),
                  .caustic = PhotonMap(photons.caustic, parallel),
                  .irradiance = {},
                  .cache = make_cache(setup)};
  if (setup.settings.precomputed_irradiance) {
    // Rays that go from the first vertex straight to another one: two segments are theirs.
    maps.irradiance =
        IrradianceMap(maps.global, setup.global, setup.global.max_length - 2, parallel);
  }
  return maps;
}

/// Every tile finds its records alone; then all tiles share them, so that the picture shows no
/// seams. The order of tiles, not of threads, is what the result depends on.
void fill_cache(const PhotonMappingPass& setup, const GatheredLight& light, const Film& film,
                const PassContext& context, IrradianceCache& cache) {
  std::vector<std::vector<IrradianceRecord>> records(tile_count(film, context));
  for_each_tile(film, context, [&](const Tile& tile) {
    records[tile.index] = GatherPoints(setup, light).trace(tile.pixels, film.filter());
  });
  for (const auto& of_tile : records) {
    for (const IrradianceRecord& record : of_tile) cache.insert(record);
  }
}

void append(std::vector<SurfacePhoton>& to, const std::vector<SurfacePhoton>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

}  // namespace

PassPhotons join(std::span<const PassPhotons> parts) {
  PassPhotons all;
  for (const PassPhotons& part : parts) {
    append(all.global, part.global);
    append(all.caustic, part.caustic);
  }
  return all;
}

void show_photons(const PhotonMappingPass& setup, const PassPhotons& photons, Film& film,
                  const PassContext& context) {
  const PhotonMappingSettings& settings = setup.settings;
  PhotonMaps maps = make_maps(setup, photons, *context.parallel);
  if (context.photons) {
    context.photons->collect(1, maps.global.photons(), maps.caustic.photons());
  }
  const GatheredLight light{
      .photons = &maps.global,
      .irradiance = settings.precomputed_irradiance ? &maps.irradiance : nullptr,
      .settings = setup.global};
  if (settings.irradiance_cache) fill_cache(setup, light, film, context, maps.cache);
  for_each_tile(film, context, [&](const Tile& tile) {
    GatherStage(setup, light, maps).render(tile.pixels, film);
  });
}

}  // namespace guidelight

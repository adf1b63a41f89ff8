#include "renderer/integrators/progressive_photons/progressive_photons.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "renderer/error.h"
#include "renderer/integrators/pixel_history.h"
#include "renderer/integrators/progressive_photons/camera_walk.h"
#include "renderer/integrators/progressive_photons/gather.h"
#include "renderer/integrators/progressive_photons/measurement_points.h"
#include "renderer/integrators/progressive_photons/settings.h"
#include "renderer/parallel/object_pool.h"
#include "renderer/photons/photon_cloud.h"
#include "renderer/photons/photon_tracer.h"

namespace guidelight {

namespace {

class ProgressivePhotons : public Integrator {
 public:
  ProgressivePhotons(std::shared_ptr<const Scene> scene, const ProgressivePhotonSettings& settings)
      : scene_(std::move(scene)),
        settings_(settings),
        max_length_(settings.max_length < 0 ? std::numeric_limits<int>::max() / 2
                                            : settings.max_length),
        initial_radius_(*scene_, settings) {
    if (settings.radius_is_zero()) {
      throw Error("a search radius of 0 finds no photons: give a larger one");
    }
  }

  void render_pass(uint32_t pass, Film& film, const PassContext& context) override {
    film.prepare_density_estimates(settings_.paths_per_pixel());
    const double pixels = static_cast<double>(film.width()) * film.height();
    light_paths_ = std::max(1.0, std::round(settings_.light_paths * pixels));
    trace_photons(pass, film, context);
    if (settings_.kind == ProgressivePhotonKind::Sppm) {
      const CameraWalk::Paths paths = camera_paths({context.seed, pass});
      ObjectPool<CameraWalk> walks([&] { return std::make_unique<CameraWalk>(*scene_, paths); });
      for_each_tile(film, context, [&](const Tile& tile) {
        walks.with([&](CameraWalk& walk) { measure_at_new_points(tile, walk, film); });
      });
    } else {
      points_.place(*scene_, camera_paths({context.seed, 0}), initial_radius_, film, context);
      for_each_tile(film, context, [&](const Tile& tile) { measure_at_fixed_points(tile, film); });
    }
    if (context.history) context.history->record(film);
  }

 private:
  struct RandomStream {
    uint64_t seed;
    uint64_t pass;
  };

  CameraWalk::Paths camera_paths(RandomStream random) const {
    return {settings_.paths_per_pixel(),
            settings_.min_length,
            max_length_,
            random.seed,
            random.pass,
            initial_radius_.needs_footprint()};
  }

  void trace_photons(uint32_t pass, const Film& film, const PassContext& context) {
    const LightPathRange paths{context.seed, pass, static_cast<size_t>(light_paths_),
                               max_length_ - 1, settings_.guided_emission(context)};
    const std::vector<Photon>& photons = tracer_.trace(*scene_, paths, *context.parallel);
    if (context.photons) context.photons->collect(light_paths_, photons);
    map_.photons.rebuild(photons, 2 * typical_radius(film), *context.parallel);
    map_.min_length = settings_.min_length;
    map_.max_length = max_length_;
  }

  /// Mean radius of some of the pixels.
  float typical_radius(const Film& film) const {
    constexpr int kStep = 8;
    float sum = 0;
    int count = 0;
    for (int y = 0; y < film.height(); y += kStep) {
      for (int x = 0; x < film.width(); x += kStep) {
        const float squared = film.density_estimates(x, y).front().radius_squared;
        if (squared > 0) sum += std::sqrt(squared), ++count;
      }
    }
    return count > 0 ? sum / static_cast<float>(count) : initial_radius_.typical();
  }

  void measure_at_new_points(const Tile& tile, CameraWalk& walk, Film& film) const {
    std::vector<FoundLight> found(kTilePixels);
    const int columns = tile.pixels.x1 - tile.pixels.x0;
    walk.trace(
        tile.pixels, film.filter(),
        [&](uint32_t i, const PathVertex& vertex, const Scattering& scattering) {
          DensityEstimate& estimate =
              film.density_estimates(tile.pixels.x0 + static_cast<int>(i) % columns,
                                     tile.pixels.y0 + static_cast<int>(i) / columns)[0];
          const CameraPath& path = walk.paths()[i];
          const GatherPoint point{
              vertex.point.position, path.weight * vertex.throughput, vertex.length,
              radius_of(estimate, initial_radius_.at(path.footprint ? &*path.footprint : nullptr))};
          gather(
              map_, point, [&]() -> const Scattering& { return scattering; }, found[i]);
        });
    finish(
        tile, found, [&](size_t pixel) { return walk.pixel_sample(pixel); }, film);
  }

  void measure_at_fixed_points(const Tile& tile, Film& film) const {
    const TilePoints& points = points_.of(tile);
    const int per_pixel = settings_.points;
    const int columns = tile.pixels.x1 - tile.pixels.x0;
    std::vector<FoundLight> found(kTilePixels * per_pixel);
    for (const MeasurementPoint& measured : points.points) {
      const int pixel = static_cast<int>(measured.path) / per_pixel;
      DensityEstimate& estimate =
          film.density_estimates(tile.pixels.x0 + pixel % columns,
                                 tile.pixels.y0 + pixel / columns)[measured.path % per_pixel];
      const GatherPoint point{measured.point.position, measured.throughput, measured.length,
                              radius_of(estimate, measured.initial_radius)};
      std::optional<SurfacePoint> restored;
      std::optional<Scattering> scattering;
      const auto scattering_at = [&]() -> const Scattering& {
        if (!scattering) {
          restored = measured.point.restore(*scene_);
          scattering.emplace(*restored, measured.point.wo, TransportMode::Radiance);
        }
        return *scattering;
      };
      gather(map_, point, scattering_at, found[measured.path]);
    }
    finish(
        tile, found, [&](size_t pixel) { return points.samples[pixel]; }, film);
  }

  /// Gives an estimate that has none its radius.
  static float radius_of(DensityEstimate& estimate, float initial) {
    if (estimate.radius_squared == 0) estimate.radius_squared = sqr(initial);
    return std::sqrt(estimate.radius_squared);
  }

  /// Closes the pass for the pixels of a tile: the film gets a sample of what was found with the
  /// present radius, the density estimates get their statistics.
  template <class SampleOf>
  void finish(const Tile& tile, const std::vector<FoundLight>& found, SampleOf&& sample_of,
              Film& film) const {
    size_t pixel = 0;
    const FoundLight* next = found.data();
    for (int y = tile.pixels.y0; y < tile.pixels.y1; ++y) {
      for (int x = tile.pixels.x0; x < tile.pixels.x1; ++x) {
        FilmSample sample = sample_of(pixel++);
        for (DensityEstimate& estimate : film.density_estimates(x, y)) {
          add_pass(*next++, estimate, sample);
        }
        film.add_sample(x, y, sample);
      }
    }
  }

  void add_pass(const FoundLight& found, DensityEstimate& estimate, FilmSample& sample) const {
    const Color flux = found.direct + found.indirect;
    if (found.count > 0) {
      const float scale =
          static_cast<float>(1 / (kPi * estimate.radius_squared * light_paths_));  // (P4)
      sample.direct += scale * found.direct;
      sample.indirect += scale * found.indirect;
      sample.caustic += scale * found.caustic;
      sample.merging += scale * flux;
      sample.bias += scale * found.excess;
    }
    // What is not a number the film rejects; it must not stay in the statistics either.
    const bool is_valid = is_finite(flux);
    estimate.add_pass(light_paths_, is_valid ? found.count : 0, flux, settings_.alpha);
  }

  std::shared_ptr<const Scene> scene_;
  ProgressivePhotonSettings settings_;
  int max_length_;
  SearchRadius initial_radius_;
  double light_paths_ = 0;  // per pass
  PhotonTracer tracer_;
  MeasuredPhotons map_{};
  MeasurementPoints points_;  // PPM
};

template <ProgressivePhotonKind kind>
std::unique_ptr<IntegratorSettings> progressive_settings(const RenderHints& hints) {
  auto settings = std::make_unique<ProgressivePhotonSettings>(kind);
  settings->max_length = hints.max_depth.value_or(settings->max_length);
  return settings;
}

std::unique_ptr<Integrator> create_progressive(std::shared_ptr<const Scene> scene,
                                               const IntegratorSettings& settings) {
  return std::make_unique<ProgressivePhotons>(
      std::move(scene), dynamic_cast<const ProgressivePhotonSettings&>(settings));
}

}  // namespace

std::vector<IntegratorInfo> progressive_photon_infos() {
  using enum ProgressivePhotonKind;
  std::vector<IntegratorInfo> list;
  list.push_back(
      {"ppm", "Progressive photon mapping",
       "Photons measured at fixed points with shrinking radii: good at light through "
       "glass seen in mirrors; depth of field and edges stay as the first pass saw them.",
       progressive_settings<Ppm>, create_progressive});
  list.push_back({"sppm", "Stochastic PPM",
                  "Progressive photon mapping with new points in every pass: good at caustics seen "
                  "in mirrors or through glass, with depth of field and fine edges.",
                  progressive_settings<Sppm>, create_progressive});
  return list;
}

}  // namespace guidelight

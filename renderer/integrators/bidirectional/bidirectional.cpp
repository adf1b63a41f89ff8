#include "renderer/integrators/bidirectional/bidirectional.h"

#include <optional>

#include "renderer/error.h"
#include "renderer/integrators/bidirectional/camera_stage.h"
#include "renderer/integrators/bidirectional/light_stage.h"
#include "renderer/parallel/concatenate.h"
#include "renderer/parallel/object_pool.h"
#include "renderer/photons/photon_cloud.h"

namespace guidelight {

namespace {

class Bidirectional : public Integrator {
 public:
  Bidirectional(std::shared_ptr<const Scene> scene, const BidirectionalSettings& settings)
      : scene_(std::move(scene)), settings_(settings) {
    const bool only_merges = settings.merges() && !settings.connections && !settings.next_event;
    if (only_merges && settings.radius_is_zero()) {
      throw Error("a merging radius of 0 finds no photons: give a larger one");
    }
  }

  void render_pass(uint32_t pass, Film& film, const PassContext& context) override {
    const size_t pixels = static_cast<size_t>(film.width()) * film.height();
    if (settings_.light_tracing) film.prepare_splats();
    if (!statistics_) statistics_ = examine_light_paths(context);
    PassSetup setup(*scene_, settings_, pass, context.seed, pixels, *statistics_);
    setup.techniques = context.techniques;
    setup.guided = settings_.guided_emission(context);
    if (settings_.merges() && settings_.lean) {
      render_lean(setup, film, context);
    } else if (settings_.merges() || settings_.connects_to_random_vertices()) {
      render_in_two_stages(setup, film, context);
    } else {
      render_tile_by_tile(setup, film, context, nullptr);
    }
  }

 private:
  /// Traces some light paths of its own where their statistics matter.
  LightPathStatistics examine_light_paths(const PassContext& context) {
    if (!settings_.connects_to_random_vertices() && !settings_.merges_nearest()) return {};
    constexpr size_t kPaths = 4096;
    const PassSetup setup(*scene_, settings_, 0, ~context.seed, kPaths);
    LightStage light(setup);
    light.trace(0, kPaths, nullptr);
    const size_t vertices =
        settings_.merges_nearest() ? light.photons().size() : light.vertices().vertices.size();
    return {static_cast<float>(std::max<size_t>(vertices, 1)) / kPaths};
  }

  /// Each tile traces its light paths and then its camera paths. Photons, if wanted, are only
  /// collected; those to merge with are given.
  void render_tile_by_tile(const PassSetup& setup, Film& film, const PassContext& context,
                           const HashGrid<Photon>* photons) {
    ObjectPool<LightStage> light_stages([&] { return std::make_unique<LightStage>(setup); });
    ObjectPool<CameraStage> camera_stages([&] { return std::make_unique<CameraStage>(setup); });
    for_each_tile(film, context, [&](const Tile& tile) {
      light_stages.with([&](LightStage& light) {
        light.trace(tile.first_of(setup.light_path_count), tile.last_of(setup.light_path_count),
                    &film);
        if (photons) tile_photons_[tile.index] = light.photons();
        const LightVertices* own = settings_.connections ? &light.vertices() : nullptr;
        camera_stages.with([&](CameraStage& camera) {
          camera.render(tile.pixels, {.own = own, .photons = photons}, film);
        });
      });
    });
  }

  /// Photons of the pass before are merged with, those of this one are kept for the next: the
  /// memory-lean variant of Georgiev et al. 2012, section 5.
  void render_lean(const PassSetup& setup, Film& film, const PassContext& context) {
    const size_t tiles = tile_count(film, context);
    // Both sides of a merge must know the same guides.
    if (grid_of_pass_ != setup.pass || guides_of_grid_ != context.guides) {
      trace_photons_before(setup, film, context);
      build_map(setup, context);
    }
    grid_of_pass_.reset();
    tile_photons_.resize(tiles);
    render_tile_by_tile(setup, film, context, &grid_);
    build_map(setup, context);
    grid_of_pass_ = setup.pass + 1;
    guides_of_grid_ = context.guides;
  }

  /// At the beginning, or after a resume, the pass before has to be made up for: its light paths
  /// are traced again. Before the first pass stands the last possible one.
  void trace_photons_before(const PassSetup& setup, const Film& film, const PassContext& context) {
    PassSetup before = setup;
    before.pass = setup.pass - 1;
    trace_light_paths(before, film, context, nullptr);
  }

  /// Fills tile_photons_ and tile_vertices_.
  void trace_light_paths(const PassSetup& setup, const Film& film, const PassContext& context,
                         Film* splats) {
    const size_t tiles = tile_count(film, context);
    tile_photons_.resize(tiles);
    tile_vertices_.resize(settings_.connections && !settings_.lean ? tiles : 0);
    ObjectPool<LightStage> stages([&] { return std::make_unique<LightStage>(setup); });
    for_each_tile(film, context, [&](const Tile& tile) {
      stages.with([&](LightStage& light) {
        light.trace(tile.first_of(setup.light_path_count), tile.last_of(setup.light_path_count),
                    splats);
        tile_photons_[tile.index] = light.photons();
        if (!tile_vertices_.empty()) tile_vertices_[tile.index].store(light.vertices());
      });
    });
  }

  /// All light paths first, then all camera paths.
  void render_in_two_stages(const PassSetup& setup, Film& film, const PassContext& context) {
    trace_light_paths(setup, film, context, &film);
    if (settings_.merges()) build_map(setup, context);
    const VertexCache cache(tile_vertices_);
    ObjectPool<LightVertices> vertices([] { return std::make_unique<LightVertices>(); });
    ObjectPool<CameraStage> stages([&] { return std::make_unique<CameraStage>(setup); });
    for_each_tile(film, context, [&](const Tile& tile) {
      LightSide side{
          .photons = settings_.merges() && !settings_.merges_nearest() ? &grid_ : nullptr,
          .nearest = settings_.merges_nearest() ? &tree_ : nullptr};
      const auto render = [&] {
        stages.with([&](CameraStage& stage) { stage.render(tile.pixels, side, film); });
      };
      if (settings_.connects_to_random_vertices()) {
        side.cache = &cache;
        render();
      } else if (settings_.connections) {
        vertices.with([&](LightVertices& own) {
          tile_vertices_[tile.index].restore(*scene_, own);
          side.own = &own;
          render();
        });
      } else {
        render();
      }
    });
  }

  void build_map(const PassSetup& setup, const PassContext& context) {
    concatenate(tile_photons_, photons_, *context.parallel);
    if (context.photons) {
      context.photons->collect(static_cast<double>(setup.light_path_count), photons_);
    }
    if (settings_.merges_nearest()) {
      tree_ = KdTree<Photon>(photons_, *context.parallel);
    } else {
      grid_.rebuild(photons_, 2 * setup.radius.typical(), *context.parallel);
    }
  }

  std::shared_ptr<const Scene> scene_;
  BidirectionalSettings settings_;
  std::optional<LightPathStatistics> statistics_;
  // By tile, kept from pass to pass for their memory.
  std::vector<std::vector<Photon>> tile_photons_;
  std::vector<StoredVertices> tile_vertices_;
  std::vector<Photon> photons_;
  HashGrid<Photon> grid_;
  KdTree<Photon> tree_;
  std::optional<uint32_t> grid_of_pass_;  // lean: the pass that the grid was made for …
  std::shared_ptr<const GuideMixture> guides_of_grid_;  // … and what its paths followed
};

template <BidirectionalKind kind>
std::unique_ptr<IntegratorSettings> bidirectional_settings(const RenderHints& hints) {
  auto settings = std::make_unique<BidirectionalSettings>(kind);
  settings->max_length = hints.max_depth.value_or(settings->max_length);
  return settings;
}

std::unique_ptr<Integrator> create_bidirectional(std::shared_ptr<const Scene> scene,
                                                 const IntegratorSettings& settings) {
  return std::make_unique<Bidirectional>(std::move(scene),
                                         dynamic_cast<const BidirectionalSettings&>(settings));
}

}  // namespace

std::vector<IntegratorInfo> bidirectional_infos() {
  using enum BidirectionalKind;
  std::vector<IntegratorInfo> list;
  list.push_back({"light", "Light tracing",
                  "Paths from the lights alone: good at caustics on surfaces that the camera sees "
                  "directly; mirrors and glass stay black.",
                  bidirectional_settings<LightTracing>, create_bidirectional});
  list.push_back({"bdpt", "Bidirectional path tracing",
                  "Camera and light paths connected: good at indirect light and directly visible "
                  "caustics; poor at caustics seen in mirrors or through glass.",
                  bidirectional_settings<Bdpt>, create_bidirectional});
  list.push_back({"pppm", "Probabilistic PPM",
                  "Photons merged where the camera first sees a surface that is not specular, with "
                  "a radius that shrinks by pass.",
                  bidirectional_settings<ProbabilisticPpm>, create_bidirectional});
  list.push_back({"bpm", "Photon merging, fixed radius",
                  "Bidirectional photon mapping with one radius: photons merged at every camera "
                  "vertex, weighted against each other.",
                  bidirectional_settings<Bpm>, create_bidirectional});
  list.push_back({"bdpm", "Bidirectional photon mapping",
                  "The nearest photons merged at every camera vertex, weighted against each other: "
                  "smooth indirect light and caustics seen in glossy surfaces.",
                  bidirectional_settings<Bdpm>, create_bidirectional});
  list.push_back({"vcm", "Vertex connection and merging",
                  "Bidirectional path tracing and photon mapping combined: the most robust choice.",
                  bidirectional_settings<Vcm>, create_bidirectional});
  for (IntegratorInfo& info : list) info.combines_techniques = true;
  return list;
}

}  // namespace guidelight

#include "renderer/integrators/path_tracer.h"

#include <algorithm>
#include <array>

#include "renderer/integrators/tiles.h"
#include "renderer/sampling/random.h"
#include "renderer/scene/bsdf/scattering.h"

namespace guidelight {

std::vector<Parameter> PathTracerSettings::parameters() {
  return {
      {"max_depth", "Longest path",
       "Longest path in segments: 1 shows emitters only, 2 adds direct light, -1 has no limit.",
       "segments", &max_depth, -1, 1024},
      {"rr_depth", "Roulette from",
       "Paths longer than this may be ended by chance, in proportion to what they still carry.",
       "segments", &russian_roulette_depth, 1, 1024},
  };
}

std::unique_ptr<IntegratorSettings> PathTracerSettings::clone() const {
  return std::make_unique<PathTracerSettings>(*this);
}

namespace {

/// A camera path under construction.
struct PathState {
  Rng rng{0, 0, 0};
  Color throughput{1.0f};
  float eta_squared = 1;   // product of squared IOR ratios that throughput carries
  float pdf = 0;           // solid-angle density of the last direction
  bool specular = true;    // the last direction could not have been found by next-event estimation
  int rough_vertices = 0;  // scatterings so far that were not specular
  Vec3 previous{0};        // the last vertex
  const Medium* medium = nullptr;
  FilmSample sample;
};

/// A shadow ray's outcome, waiting for its visibility.
struct PendingLight {
  uint32_t path;
  bool direct;
  Color contribution;
};

/// Power heuristic with exponent 2 (Veach 1997, 9.2.4).
float power_heuristic(float pdf, float other) {
  if (!std::isfinite(pdf)) return 1;
  const float ratio = other / pdf;
  return 1 / (1 + ratio * ratio);
}

/// All paths of one tile, advanced together segment by segment so that their rays are traced in
/// batches.
class TilePaths {
 public:
  TilePaths(const Scene& scene, const PathTracerSettings& settings)
      : scene_(scene), settings_(settings) {}

  void render(const PixelRegion& tile, uint32_t pass, uint64_t seed, Film& film) {
    start(tile, pass, seed, film.filter());
    for (int depth = 1; active_count_ > 0; ++depth) {
      scene_.intersect({rays_.data(), active_count_}, {hits_.data(), active_count_});
      advance(depth);
      gather_light();
    }
    size_t i = 0;
    for (int y = tile.y0; y < tile.y1; ++y) {
      for (int x = tile.x0; x < tile.x1; ++x) film.add_sample(x, y, paths_[i++].sample);
    }
  }

 private:
  void start(const PixelRegion& tile, uint32_t pass, uint64_t seed, const Filter& filter) {
    const Camera& camera = scene_.camera();
    active_count_ = 0;
    for (int y = tile.y0; y < tile.y1; ++y) {
      for (int x = tile.x0; x < tile.x1; ++x) {
        PathState& path = paths_[active_count_];
        path = PathState{};
        path.rng = Rng(seed, pass, static_cast<uint64_t>(y) * camera.width() + x);
        const Filter::Sample offset = filter.sample(path.rng.next_vec2());
        const CameraSample sample =
            camera.sample_ray(Vec2(x + 0.5f, y + 0.5f) + offset.offset, path.rng.next_vec2());
        path.throughput = sample.weight;
        path.sample.filter_weight = offset.weight;
        path.medium = scene_.camera_medium();
        path.previous = sample.ray.origin;
        rays_[active_count_] = sample.ray;
        active_[active_count_] = static_cast<uint32_t>(active_count_);
        ++active_count_;
      }
    }
  }

  /// One vertex for every path that is still alive; survivors are packed to the front, in order.
  void advance(int depth) {
    light_count_ = 0;
    size_t survivors = 0;
    for (size_t i = 0; i < active_count_; ++i) {
      Ray ray = rays_[i];
      if (!extend(active_[i], depth, hits_[i], ray)) continue;
      rays_[survivors] = ray;
      active_[survivors++] = active_[i];
    }
    active_count_ = survivors;
  }

  /// Adds emission at the end of `ray`, queues a shadow ray, and replaces `ray` by the next
  /// segment. False if the path ends here.
  bool extend(uint32_t index, int depth, const Hit& hit, Ray& ray) {
    PathState& path = paths_[index];
    if (!hit.valid()) {
      add_environment(path, depth, ray.direction);
      return false;
    }
    if (path.medium) path.throughput *= path.medium->transmittance(hit.t);
    const SurfacePoint point = scene_.surface_point(ray, hit);
    if (depth == 1) record_first_hit(path.sample, point, hit.t);
    if (point.light) add_emission(path, depth, point, -ray.direction);
    if (settings_.max_depth >= 0 && depth >= settings_.max_depth) return false;

    const Scattering scattering(point, -ray.direction, TransportMode::Radiance);
    if (scattering.is_connectible()) queue_light(index, depth, point, scattering);
    return scatter(path, depth, point, scattering, ray);
  }

  /// Light that the path ran into.
  static void add(PathState& path, int depth, Color contribution) {
    (depth <= 2 ? path.sample.direct : path.sample.indirect) += contribution;
    // Next-event estimation finds no caustics, as its last vertex is not specular.
    if (path.specular && path.rough_vertices == 1) path.sample.caustic += contribution;
  }

  void add_environment(PathState& path, int depth, Vec3 direction) {
    if (path.medium) path.throughput *= path.medium->transmittance(kInfinity);
    for (const Light* light : scene_.infinite_lights()) {
      const Color radiance = light->radiance_from(direction);
      if (is_black(radiance)) continue;
      const float weight = path.specular
                               ? 1.0f
                               : power_heuristic(path.pdf, light->pdf_direct_from(direction) *
                                                               scene_.light_probability(*light));
      add(path, depth, path.throughput * radiance * weight);
    }
  }

  void add_emission(PathState& path, int depth, const SurfacePoint& point, Vec3 wo) {
    const Color radiance = point.light->radiance(point, wo);
    if (is_black(radiance)) return;
    const float weight =
        path.specular ? 1.0f
                      : power_heuristic(path.pdf, point.light->pdf_direct(path.previous, point) *
                                                      scene_.light_probability(*point.light));
    add(path, depth, path.throughput * radiance * weight);
  }

  /// Next-event estimation: draws a point on a light and queues the shadow ray.
  void queue_light(uint32_t index, int depth, const SurfacePoint& point,
                   const Scattering& scattering) {
    PathState& path = paths_[index];
    const auto choice = scene_.choose_light(path.rng.next_float());
    if (!choice) return;
    const auto sample = choice->light->sample_direct(point.position, path.rng.next_vec2());
    if (!sample) return;
    const BsdfEvaluation bsdf = scattering.evaluate(sample->wi);
    if (is_black(bsdf.value)) return;
    const float pdf = sample->pdf * choice->probability;
    // A delta light cannot be hit by chance: next-event estimation stands alone.
    const float weight = choice->light->is_delta() ? 1.0f : power_heuristic(pdf, bsdf.pdf);
    Color contribution = path.throughput * bsdf.value * sample->radiance * (weight / pdf);
    if (const Medium* medium = medium_beyond(point, sample->wi, path.medium)) {
      contribution *= medium->transmittance(sample->distance);
    }
    shadow_rays_[light_count_] = choice->light->is_infinite() ? point.spawn_ray(sample->wi)
                                 : choice->light->is_delta()  ? point.spawn_ray_to(sample->position)
                                                              : point.spawn_ray_to(sample->point);
    pending_[light_count_++] = {index, depth + 1 <= 2, contribution};
  }

  void gather_light() {
    scene_.occluded({shadow_rays_.data(), light_count_}, {blocked_.data(), light_count_});
    for (size_t i = 0; i < light_count_; ++i) {
      if (blocked_[i]) continue;
      FilmSample& sample = paths_[pending_[i].path].sample;
      (pending_[i].direct ? sample.direct : sample.indirect) += pending_[i].contribution;
    }
  }

  bool scatter(PathState& path, int depth, const SurfacePoint& point, const Scattering& scattering,
               Ray& ray) {
    const float u_lobe = path.rng.next_float();
    const auto sample = scattering.sample(u_lobe, path.rng.next_vec2());
    if (!sample) return false;
    path.throughput *= sample->weight;
    path.eta_squared *= sqr(sample->eta);
    if (depth >= settings_.russian_roulette_depth) {
      // Radiance that was compressed by entering glass is decompressed on leaving it: it is no
      // reason to end the path, so the factor is taken out.
      const float survival = std::min(max_component(path.throughput) * path.eta_squared, 0.95f);
      if (path.rng.next_float() >= survival) return false;
      path.throughput /= survival;
    }
    path.pdf = sample->pdf;
    path.specular = sample->is_delta();
    if (!path.specular) ++path.rough_vertices;
    path.previous = point.position;
    path.medium = medium_beyond(point, sample->wi, path.medium);
    ray = point.spawn_ray(sample->wi);
    return true;
  }

  const Scene& scene_;
  const PathTracerSettings& settings_;
  size_t active_count_ = 0;
  size_t light_count_ = 0;
  std::array<PathState, kTilePixels> paths_;
  std::array<Ray, kTilePixels> rays_;
  std::array<Hit, kTilePixels> hits_;
  std::array<uint32_t, kTilePixels> active_;  // rays_[i] belongs to paths_[active_[i]]
  std::array<Ray, kTilePixels> shadow_rays_;
  std::array<PendingLight, kTilePixels> pending_;
  std::array<uint8_t, kTilePixels> blocked_;
};

class PathTracer : public Integrator {
 public:
  PathTracer(std::shared_ptr<const Scene> scene, const PathTracerSettings& settings)
      : scene_(std::move(scene)), settings_(settings) {}

  void render_pass(uint32_t pass, Film& film, const PassContext& context) override {
    for_each_tile(film, context, [&](const Tile& tile) {
      TilePaths(*scene_, settings_).render(tile.pixels, pass, context.seed, film);
    });
  }

 private:
  std::shared_ptr<const Scene> scene_;
  PathTracerSettings settings_;
};

std::unique_ptr<IntegratorSettings> path_tracer_settings(const RenderHints& hints) {
  auto settings = std::make_unique<PathTracerSettings>();
  settings->max_depth = hints.max_depth.value_or(settings->max_depth);
  settings->russian_roulette_depth =
      hints.russian_roulette_depth.value_or(settings->russian_roulette_depth);
  return settings;
}

std::unique_ptr<Integrator> create_path_tracer(std::shared_ptr<const Scene> scene,
                                               const IntegratorSettings& settings) {
  return std::make_unique<PathTracer>(std::move(scene),
                                      dynamic_cast<const PathTracerSettings&>(settings));
}

}  // namespace

IntegratorInfo path_tracer_info() {
  return {"path", "Path tracer",
          "Unbiased reference: good at open scenes, large lights and glossy surfaces; poor at "
          "caustics and light through small openings.",
          path_tracer_settings, create_path_tracer};
}

}  // namespace guidelight

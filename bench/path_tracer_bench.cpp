// How fast the path tracer is, and how fast it could be: the same rays, batch by batch, replayed
// through the accelerator alone.
//
//   path_tracer_bench [SCENE]      default: scenes/mirror-glass-box at 512x512, path depth 12

#include <benchmark/benchmark.h>

#include "bench/ray_replay.h"
#include "renderer/integrators/path_tracer.h"
#include "renderer/io/scene_file.h"

namespace guidelight {
namespace {

constexpr int kSide = 512;
constexpr int kDepth = 12;
constexpr int kThreads = 2;

std::string scene_path = GUIDELIGHT_SOURCE_DIR "/scenes/mirror-glass-box/scene.xml";

std::shared_ptr<const Scene> load_scene() {
  auto description = std::make_shared<SceneDescription>(read_scene(scene_path));
  description->film.width = description->film.height = kSide;
  return Scene::build(description);
}

std::unique_ptr<Integrator> make_integrator(std::shared_ptr<const Scene> scene) {
  PathTracerSettings settings;
  settings.max_depth = kDepth;
  return path_tracer_info().create(std::move(scene), settings);
}

/// All rays of one pass, as the path tracer's batches.
RayLog& logged_rays() {
  static RayLog log;
  if (log.batches().empty()) {
    Film film(kSide, kSide);
    Parallel parallel(1);
    make_integrator(load_scene()->with_ray_log(log))->render_pass(0, film, {0, &parallel, {}});
  }
  return log;
}

void report(benchmark::State& state, size_t rays_per_pass) {
  const double passes = static_cast<double>(state.iterations());
  state.counters["rays/s"] = {passes * rays_per_pass, benchmark::Counter::kIsRate};
  state.counters["paths/s"] = {passes * kSide * kSide, benchmark::Counter::kIsRate};
  state.counters["rays/path"] = static_cast<double>(rays_per_pass) / (kSide * kSide);
}

void path_tracer(benchmark::State& state) {
  const auto integrator = make_integrator(load_scene());
  Parallel parallel(static_cast<int>(state.range(0)));
  Film film(kSide, kSide);
  uint32_t pass = 0;
  for (auto _ : state) integrator->render_pass(pass++, film, {0, &parallel, {}});
  report(state, count_rays(logged_rays()).total());
}

void replay(benchmark::State& state) {
  const auto scene = load_scene();
  Parallel parallel(static_cast<int>(state.range(0)));
  const RayLog& log = logged_rays();
  for (auto _ : state) trace_again(log, *scene, parallel);
  report(state, count_rays(logged_rays()).total());
}

BENCHMARK(path_tracer)->Arg(1)->Arg(kThreads)->ArgName("threads")->UseRealTime()->MinTime(3);
BENCHMARK(replay)->Arg(1)->Arg(kThreads)->ArgName("threads")->UseRealTime()->MinTime(3);

}  // namespace
}  // namespace guidelight

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (argc > 1) guidelight::scene_path = argv[1];
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}

// Passes per second of every integrator, and rays per second beside the same rays replayed through
// the accelerator alone.
//
//   integrator_bench [--benchmark_filter=vcm] [SCENE]
//   default: scenes/mirror-glass-box at 512x512, paths of at most 10 segments, one light path per
//   pixel

#include <benchmark/benchmark.h>

#include <map>

#include "bench/ray_replay.h"
#include "renderer/integrators/integrator.h"
#include "renderer/io/scene_file.h"

namespace guidelight {
namespace {

constexpr int kSide = 512;

std::string scene_path = GUIDELIGHT_SOURCE_DIR "/scenes/mirror-glass-box/scene.xml";

std::shared_ptr<const Scene> scene() {
  static const std::shared_ptr<const Scene> loaded = [] {
    auto description = std::make_shared<SceneDescription>(read_scene(scene_path));
    description->film.width = description->film.height = kSide;
    description->hints.max_depth = 10;
    return Scene::build(description);
  }();
  return loaded;
}

std::unique_ptr<Integrator> make_integrator(const IntegratorInfo& info,
                                            std::shared_ptr<const Scene> of) {
  return info.create(of, *info.make_settings(of->description().hints));
}

/// All rays of one pass.
const RayLog& logged_rays(const IntegratorInfo& info) {
  static std::map<std::string, RayLog> logs;
  RayLog& log = logs[info.name];
  if (log.batches().empty()) {
    Film film(kSide, kSide);
    Parallel parallel(2);
    make_integrator(info, scene()->with_ray_log(log))->render_pass(0, film, {0, &parallel, {}});
  }
  return log;
}

void report(benchmark::State& state, const RayLog& log) {
  const RayCounts rays = count_rays(log);
  const double passes = static_cast<double>(state.iterations());
  state.counters["passes/s"] = {passes, benchmark::Counter::kIsRate};
  state.counters["rays/s"] = {passes * rays.total(), benchmark::Counter::kIsRate};
  state.counters["rays/pixel"] = static_cast<double>(rays.total()) / (kSide * kSide);
  state.counters["shadow/pixel"] = static_cast<double>(rays.shadow) / (kSide * kSide);
}

void passes(benchmark::State& state, const IntegratorInfo& info) {
  const auto integrator = make_integrator(info, scene());
  Parallel parallel(static_cast<int>(state.range(0)));
  Film film(kSide, kSide);
  uint32_t pass = 0;
  for (auto _ : state) {
    integrator->render_pass(pass++, film, {0, &parallel, {}});
    film.finish_pass();
  }
  report(state, logged_rays(info));
}

void replay(benchmark::State& state, const IntegratorInfo& info) {
  Parallel parallel(static_cast<int>(state.range(0)));
  const RayLog& log = logged_rays(info);
  for (auto _ : state) trace_again(log, *scene(), parallel);
  report(state, logged_rays(info));
}

/// Shadow rays alone, as batches or one by one: what packets bring to connections.
void shadow_rays(benchmark::State& state, const IntegratorInfo& info, bool as_packets) {
  const RayLog& log = logged_rays(info);
  size_t rays = 0;
  for (auto _ : state) {
    rays = 0;
    for (const auto& batch : log.batches()) {
      if (!batch.shadow) continue;
      std::vector<uint8_t> blocked(batch.rays.size());
      if (as_packets) {
        scene()->occluded(batch.rays, blocked);
      } else {
        for (size_t i = 0; i < batch.rays.size(); ++i)
          blocked[i] = scene()->occluded(batch.rays[i]);
      }
      benchmark::DoNotOptimize(blocked.data());
      rays += batch.rays.size();
    }
  }
  state.counters["rays/s"] = {static_cast<double>(state.iterations()) * rays,
                              benchmark::Counter::kIsRate};
}

}  // namespace
}  // namespace guidelight

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (argc > 1) guidelight::scene_path = argv[1];
  for (const auto& info : guidelight::integrators()) {
    const auto add = [&](const std::string& name, auto function) {
      benchmark::RegisterBenchmark((info.name + name).c_str(), function, info)
          ->Arg(1)
          ->Arg(2)
          ->Unit(benchmark::kMillisecond)
          ->UseRealTime();
    };
    add("/passes", guidelight::passes);
    add("/replay", guidelight::replay);
  }
  const auto& bdpt = guidelight::find_integrator("bdpt");
  benchmark::RegisterBenchmark("bdpt/shadow_packets", guidelight::shadow_rays, bdpt, true);
  benchmark::RegisterBenchmark("bdpt/shadow_one_by_one", guidelight::shadow_rays, bdpt, false);
  benchmark::RunSpecifiedBenchmarks();
}

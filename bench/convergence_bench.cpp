// How fast the error falls: relative RMS error against the number of passes, and the exponent that
// fits a decade of it.
//
//   convergence_bench [PLOT.svg]
//   The plain Cornell box at 64x64; the reference is BDPT with many more passes.

#include <fmt/core.h>

#include <cmath>
#include <map>

#include "bench/log_plot.h"
#include "renderer/image/metrics.h"
#include "renderer/integrators/integrator.h"
#include "renderer/io/scene_file.h"

namespace guidelight {
namespace {

constexpr int kSide = 64;
constexpr uint32_t kFirst = 16;
constexpr uint32_t kLast = 256;
constexpr uint32_t kReferencePasses = 12288;
/// Large enough [%] that photons are found from the first pass on: asymptotic rates are not seen
/// before.
constexpr const char* kRadius = "2";
constexpr int kRuns = 5;  // independent, their squared errors averaged

std::shared_ptr<const Scene> load_scene() {
  auto description = std::make_shared<SceneDescription>(
      read_scene(GUIDELIGHT_SOURCE_DIR "/scenes/cornell/scene.xml"));
  description->film.width = description->film.height = kSide;
  description->hints.max_depth = 8;
  return Scene::build(description);
}

/// Square of the relative RMS error of one run.
double squared_error(const Film& film, const Image& reference) {
  return compare_images(film.develop(Layer::Beauty), reference).relative_mse.plain;
}

/// Calls visit(passes, film) after 2^i passes.
template <typename Visit>
void render(std::shared_ptr<const Scene> scene, const std::string& name, uint64_t seed,
            uint32_t last, Visit&& visit) {
  const IntegratorInfo& info = find_integrator(name);
  const auto settings = info.make_settings(scene->description().hints);
  for (const Parameter& parameter : settings->parameters()) {
    if (parameter.key == "scene_radius") set_parameter(*settings, parameter.key, kRadius);
  }
  const auto integrator = info.create(scene, *settings);
  Parallel parallel;
  Film film(kSide, kSide, scene->camera().film().filter);
  for (uint32_t pass = 0; pass < last; ++pass) {
    integrator->render_pass(pass, film, {.seed = seed, .parallel = &parallel});
    film.finish_pass();
    if (const uint32_t passes = pass + 1; passes == last || (passes & (passes - 1)) == 0) {
      visit(passes, film);
    }
  }
}

void run(const std::string& plot_path) {
  const auto scene = load_scene();
  Image reference;
  render(scene, "bdpt", 99, kReferencePasses,
         [&](uint32_t, const Film& film) { reference = film.develop(Layer::Beauty); });
  std::vector<LogSeries> plot;
  for (const char* name : {"bdpt", "vcm", "sppm", "pppm", "bpm"}) {
    std::map<uint32_t, double> errors;
    for (uint64_t seed = 0; seed < kRuns; ++seed) {
      render(scene, name, seed, kLast, [&](uint32_t passes, const Film& film) {
        if (passes >= kFirst) errors[passes] += squared_error(film, reference) / kRuns;
      });
    }
    LogSeries series{name, {}, {}};
    for (const auto& [passes, squared] : errors) {
      series.x.push_back(passes);
      series.y.push_back(std::sqrt(squared));
    }
    const double exponent = fitted_exponent(series);
    fmt::print("{:6} N^{:+.3f}   {:.5f} after {} passes, {:.5f} after {}\n", name, exponent,
               series.y.front(), kFirst, series.y.back(), kLast);
    series.name = fmt::format("{}, N^{:.2f}", name, exponent);
    plot.push_back(series);
  }
  if (!plot_path.empty()) {
    write_log_plot(plot_path, "Error of the Cornell box by passes", "passes",
                   "square root of relMSE", plot);
  }
}

}  // namespace
}  // namespace guidelight

int main(int argc, char** argv) { guidelight::run(argc > 1 ? argv[1] : ""); }

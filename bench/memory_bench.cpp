// Whether memory grows with the number of passes, and what one photon, point and vertex take.
//
//   memory_bench [SCENE]      default: scenes/mirror-glass-box at 64x64

#include <fmt/format.h>

#include "renderer/integrators/bidirectional/light_vertices.h"
#include "renderer/integrators/progressive_photons/measurement_points.h"
#include "renderer/io/scene_file.h"
#include "renderer/parallel/process_memory.h"
#include "renderer/photons/photon.h"

namespace guidelight {
namespace {

constexpr int kSide = 64;

double resident_megabytes() { return 1e-6 * static_cast<double>(resident_bytes()); }

void print_growth(const std::shared_ptr<const Scene>& scene, const std::string& name) {
  const IntegratorInfo& info = find_integrator(name);
  const auto integrator = info.create(scene, *info.make_settings(scene->description().hints));
  Parallel parallel(2);
  Film film(kSide, kSide);
  double after_10 = 0;
  for (uint32_t pass = 0; pass < 1000; ++pass) {
    integrator->render_pass(pass, film, {0, &parallel});
    film.finish_pass();
    if (pass + 1 == 10) after_10 = resident_megabytes();
  }
  const double after_1000 = resident_megabytes();
  fmt::print("{:6} {:10.1f} MB {:12.1f} MB {:+9.2f} %\n", name, after_10, after_1000,
             100 * (after_1000 / after_10 - 1));
}

void print_all(const std::string& path) {
  fmt::print("bytes per photon                 {}\n", sizeof(Photon));
  fmt::print("bytes per light vertex at rest   {}\n", sizeof(StoredVertex));
  fmt::print("bytes per measurement point      {}, and {} for its statistics\n",
             sizeof(MeasurementPoint), sizeof(DensityEstimate));
  fmt::print("\nresident after  10 passes    1000 passes    growth\n");
  auto description = std::make_shared<SceneDescription>(read_scene(path));
  description->film.width = description->film.height = kSide;
  const auto scene = Scene::build(description);
  for (const char* name : {"ppm", "sppm", "vcm"}) print_growth(scene, name);
}

}  // namespace
}  // namespace guidelight

int main(int argc, char** argv) {
  guidelight::print_all(argc > 1 ? argv[1]
                                 : GUIDELIGHT_SOURCE_DIR "/scenes/mirror-glass-box/scene.xml");
}

#include "renderer/integrators/photon_mapping/emission_stage.h"

#include <algorithm>

namespace guidelight {

namespace {

/// Light paths draw other random numbers than the camera path of the same number.
constexpr uint64_t kEmissionStream = 0x70686f746f6eull;
constexpr size_t kPathsPerTask = 1024;

}  // namespace

EmissionStage::EmissionStage(const PhotonMappingPass& setup, PowerOfVertex power)
    : setup_(setup),
      power_(std::move(power)),
      walk_(setup.scene, TransportMode::Importance),
      batch_(setup.scene, 1, setup.guided) {}

PassPhotons EmissionStage::trace_all(const PhotonMappingPass& setup, Parallel& parallel,
                                     const PowerOfVertex& power) {
  const auto count = static_cast<size_t>(setup.settings.light_paths);
  std::vector<PassPhotons> parts((count + kPathsPerTask - 1) / kPathsPerTask);
  parallel.for_each(parts.size(), [&](size_t task) {
    EmissionStage stage(setup, power);
    stage.trace(task * kPathsPerTask, std::min(count, (task + 1) * kPathsPerTask));
    parts[task] = std::move(stage.photons_);
  });
  return join(parts);
}

void EmissionStage::trace(size_t first, size_t last) {
  batch_.reset(last - first);
  for (size_t i = first; i < last; ++i) {
    batch_.add(Rng(setup_.seed ^ kEmissionStream, setup_.pass, i));
  }
  is_sharp_.assign(batch_.paths().size(), 1);
  walk_.run(batch_.paths(), *this);
}

bool EmissionStage::visit(uint32_t index, Subpath& path, const PathVertex& vertex,
                          const Scattering& scattering) {
  const int max_length = setup_.global.max_length;
  if (path.length > 0 && !setup_.global.sharp.at_origin(path)) is_sharp_[index] = 0;
  if (vertex.is_connectible()) {
    keep(vertex, scattering, is_sharp_[index] && vertex.length > 1);
    if (path.guided) path.guided->left_photon(vertex.point.position);
  }
  // The next vertex is of use if at least one segment may follow it.
  return vertex.length + 1 < max_length;
}

void EmissionStage::keep(const PathVertex& vertex, const Scattering& scattering, bool is_caustic) {
  const auto photon = [&](bool for_caustic_map) {
    const Color power = power_
                            ? power_(vertex, scattering, for_caustic_map)
                            : vertex.throughput / static_cast<float>(setup_.settings.light_paths);
    return make_surface_photon(vertex, power, is_caustic);
  };
  const int max_length = setup_.global.max_length;
  if (is_caustic && vertex.length < max_length) photons_.caustic.push_back(photon(true));
  if (vertex.length < max_length - 1) photons_.global.push_back(photon(false));
}

}  // namespace guidelight

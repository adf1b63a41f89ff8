#pragma once

#include <vector>

#include "renderer/image/film.h"
#include "renderer/integrators/bidirectional/light_vertices.h"
#include "renderer/integrators/bidirectional/pass_setup.h"
#include "renderer/photons/photon.h"
#include "renderer/transport/light_path_batch.h"
#include "renderer/transport/path_weights.h"

namespace guidelight {

/// Traces light paths: connects their vertices to the lens (t = 1) and keeps them for the camera
/// stage, as vertices to connect to and as photons to merge with.
class LightStage {
 public:
  explicit LightStage(const PassSetup& setup);

  /// Traces paths [first, last) of the pass. `film` receives the splats and the count, null if they
  /// are not wanted.
  void trace(size_t first, size_t last, Film* film);

  /// Of the last trace().
  const LightVertices& vertices() const { return vertices_; }
  /// Their power is the shaded_power(), times the number of light paths.
  const std::vector<Photon>& photons() const { return photons_; }

  // RandomWalk's visitor.
  void escaped(uint32_t, Subpath&) {}
  bool visit(uint32_t index, Subpath& path, const PathVertex& vertex, const Scattering& scattering);
  void end_segment();

 private:
  /// A batch of paths; `first_slot` is the place of the first among all of the trace().
  void start(size_t first, size_t last, size_t first_slot);
  void add_photon(Subpath& path, const PathVertex& vertex, Color power);
  void record_techniques();
  void queue_splat(Subpath& path, const PathVertex& vertex, const Scattering& scattering);

  const PassSetup& setup_;
  RandomWalk walk_;
  Film* film_ = nullptr;
  LightVertices vertices_;
  std::vector<Photon> photons_;
  LightPathBatch batch_;
  std::vector<uint32_t> slots_;  // which of the trace() each path of the batch is
  // Splats and what belongs to each.
  std::vector<Splat> splats_;
  std::vector<Vec2> filter_u_;
  std::vector<Ray> shadow_rays_;
  struct Unweighted {
    Color contribution;
    int s;
  };
  std::vector<Unweighted> unweighted_;  // of each splat, if techniques are kept apart
  std::vector<uint8_t> blocked_;
};

}  // namespace guidelight

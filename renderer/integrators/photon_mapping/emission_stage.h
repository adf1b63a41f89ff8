#pragma once

#include <functional>
#include <vector>

#include "renderer/integrators/photon_mapping/second_pass.h"
#include "renderer/transport/light_path_batch.h"
#include "renderer/transport/random_walk.h"

namespace guidelight {

/// Power of the photon of a light vertex, where photons are also made otherwise.
using PowerOfVertex =
    std::function<Color(const PathVertex&, const Scattering&, bool for_caustic_map)>;

/// The first of the two passes: traces light paths and keeps their vertices as photons.
class EmissionStage {
 public:
  /// Without `power`, light paths alone make all photons.
  explicit EmissionStage(const PhotonMappingPass& setup, PowerOfVertex power = {});

  /// Photons of all light paths of the pass, in order.
  static PassPhotons trace_all(const PhotonMappingPass& setup, Parallel& parallel,
                               const PowerOfVertex& power = {});

  /// Traces paths [first, last).
  void trace(size_t first, size_t last);

  // RandomWalk's visitor.
  void escaped(uint32_t, Subpath&) {}
  bool visit(uint32_t index, Subpath& path, const PathVertex& vertex, const Scattering& scattering);
  void end_segment() {}

 private:
  void keep(const PathVertex& vertex, const Scattering& scattering, bool is_caustic);

  const PhotonMappingPass& setup_;
  PowerOfVertex power_;
  RandomWalk walk_;
  PassPhotons photons_;
  LightPathBatch batch_;
  std::vector<uint8_t> is_sharp_;  // whether each path has scattered sharply alone
};

}  // namespace guidelight

#pragma once

#include <vector>

#include "renderer/parallel/parallel.h"
#include "renderer/photons/photon.h"
#include "renderer/transport/guided_walk.h"
#include "renderer/transport/random_walk.h"

namespace guidelight {

/// The light paths of one pass: random numbers depend on (seed, pass, path) only. Empty `guided`:
/// no path follows a guide.
struct LightPathRange {
  uint64_t seed;
  uint64_t pass;
  size_t count;
  int max_length;  // segments
  std::optional<GuidedEmission> guided = std::nullopt;
};

/// Traces light paths in parallel and keeps a photon of every vertex that is not perfectly
/// specular, direct light included. Photon::power() is the shaded_power() in watts times the number
/// of light paths.
/// Keeps its memory from pass to pass.
class PhotonTracer {
 public:
  /// In the order of the paths, on any number of threads. Throws Stopped.
  const std::vector<Photon>& trace(const Scene& scene, const LightPathRange& paths,
                                   Parallel& parallel);

  size_t bytes() const;

 private:
  std::vector<std::vector<Photon>> batches_;
  std::vector<Photon> photons_;
};

}  // namespace guidelight

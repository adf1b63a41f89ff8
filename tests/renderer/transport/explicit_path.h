#pragma once

#include <vector>

#include "renderer/scene/scene.h"
#include "renderer/transport/mis.h"

namespace guidelight::testing {

/// A full path as plain vertices, from the light to the lens, and the densities of every technique
/// that could have made it, each multiplied out from its definition: the oracle of the balance
/// heuristic, which shares nothing with the recurrence.
struct ExplicitPath {
  /// x₀. For lights at infinity `towards` counts, for others the position.
  const Light* light = nullptr;
  SurfacePoint light_point;
  Vec3 light_position{0};
  Vec3 towards{0};

  struct Vertex {
    SurfacePoint point;
    bool is_delta;  // it scatters by a delta lobe
  };
  std::vector<Vertex> vertices;  // x₁ … x_{k-1}
  Vec3 lens{0};                  // x_k

  int length() const { return static_cast<int>(vertices.size()) + 1; }
};

/// Weights of all techniques that sample the path. They sum to 1.
struct OracleWeights {
  std::vector<double> connection;  // by s = 0 … k; t = k + 1 - s
  std::vector<double> merging;     // by m = 0 … k - 1: merged at x_m
};

/// `eta`: light paths merged with × merging area.
OracleWeights oracle_weights(const Scene& scene, const ExplicitPath& path,
                             const TechniqueCounts& counts, double eta);

}  // namespace guidelight::testing

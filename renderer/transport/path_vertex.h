#pragma once

#include "renderer/scene/medium.h"
#include "renderer/scene/scene.h"
#include "renderer/transport/mis_partials.h"

namespace guidelight {

/// A vertex on a surface that a random walk has reached; the light or the lens where the walk
/// began is vertex 0 and is not one of these.
struct PathVertex {
  SurfacePoint point;
  Hit hit;
  Vec3 wo;           // unit, towards the vertex before
  Color throughput;  // of the path up to here, divided by its density; no scattering here yet
  MisPartials partials;
  /// The part of partials.merging without the vertex just before; on a camera path that ends on a
  /// light, a merge at that vertex would be one of direct light.
  float merging_before_last;
  const Medium* medium;    // that the arriving segment passed
  float survival;          // probability that the walk goes on from here
  int length;              // segments from vertex 0
  float merge_share = 1;   // of a camera path: product of MisWeights::independence so far
  bool is_specular_chain;  // every vertex before (if any) scattered by a delta lobe

  /// Light vertex of a caustic: light came here by specular bounces alone, at least one.
  bool is_caustic() const { return is_specular_chain && length > 1; }

  /// Some lobe is finite: connections and merges are possible.
  bool is_connectible() const { return point.bsdf->lobes() & kLobeSmooth; }
};

/// Transmittance of a straight segment that leaves a vertex.
inline Color segment_transmittance(const PathVertex& vertex, Vec3 direction, float distance) {
  const Medium* medium = medium_beyond(vertex.point, direction, vertex.medium);
  return medium ? medium->transmittance(distance) : Color(1.0f);
}

}  // namespace guidelight

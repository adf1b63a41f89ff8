#pragma once

#include "renderer/transport/connect.h"
#include "renderer/transport/mis.h"
#include "renderer/transport/random_walk.h"

namespace guidelight {

// The balance heuristic's weight of each way to close a path. `eta` is the number of light paths
// merged with times the merging area, of this path. Derivation in docs/mis.md.

/// s = 1.
float path_weight(const MisWeights& weights, const PathVertex& vertex,
                  const DirectConnection& connection, float eta);

/// s, t ≥ 2.
float path_weight(const MisWeights& weights, const PathVertex& light, const PathVertex& camera,
                  const VertexConnection& connection, float eta);

/// t = 1.
float path_weight(const MisWeights& weights, const PathVertex& vertex,
                  const LensConnection& connection, float eta);

/// s = 0: a camera path that ran into an emitter after at least one scattering. `guided` as of
/// connect_to_light.
struct EmissionEnd {
  MisPartials partials;       // of the vertex on the light
  float merging_before_last;  // see PathVertex
  bool is_direct_caustic;     // the camera's first vertex scattered finitely and no other did
  float pdf_direct;           // of next-event estimation, in the measure of the vertex
  float pdf_emission;         // of emission, position × direction
};
EmissionEnd end_on_light(const Scene& scene, const Subpath& path, const PathVertex& vertex,
                         bool is_direct_caustic, const GuidedEmission* guided = nullptr);
/// The same for a light at infinity.
EmissionEnd end_at_infinity(const Scene& scene, const Subpath& path, const Light& light,
                            bool is_direct_caustic, const GuidedEmission* guided = nullptr);
float path_weight(const MisWeights& weights, const EmissionEnd& end, float eta);

/// A photon merged with a camera vertex; the densities are of scattering there.
struct Merge {
  MisPartials photon;
  int photon_length;    // segments of the light path
  float pdf_to_light;   // from the camera towards the light, survival included
  float pdf_to_camera;  // from the light towards the camera, survival included
};
float path_weight(const MisWeights& weights, const PathVertex& vertex, const Merge& merge,
                  float eta);

}  // namespace guidelight

#pragma once

#include <optional>

#include "renderer/scene/bsdf/scattering.h"
#include "renderer/transport/guided_walk.h"
#include "renderer/transport/path_vertex.h"

namespace guidelight {

// Every way to close a path between two subpaths. Each returns the contribution without weight and
// visibility, with the densities that the weight needs: `pdf_arrival` of sampling a vertex from the
// other side [per area, survival of the scattering vertex included], `pdf_backward` of scattering
// at a vertex back along its own subpath [per solid angle, survival included]. Empty where nothing
// is carried.

/// A camera vertex connected to a point on a light: s = 1. `guided` is how light paths are emitted,
/// if they follow guides.
struct DirectConnection {
  Ray shadow_ray;
  Color contribution;
  float pdf_backward;    // at the camera vertex
  float emission_ratio;  // density of emitting this segment up to the vertex / of this connection
  float hit_ratio;       // density of finding the light by scattering / of this connection
};
std::optional<DirectConnection> connect_to_light(const Scene& scene, const PathVertex& vertex,
                                                 const Scattering& scattering, float u_light,
                                                 Vec2 u_point,
                                                 const GuidedEmission* guided = nullptr);

/// Vertices of a light and a camera path connected: s, t ≥ 2.
struct VertexConnection {
  Ray shadow_ray;
  Color contribution;
  float pdf_arrival_light;
  float pdf_backward_light;
  float pdf_arrival_camera;
  float pdf_backward_camera;
  float pdf_scattering_camera;  // towards the light's vertex, per solid angle
};
std::optional<VertexConnection> connect_vertices(const PathVertex& light,
                                                 const Scattering& light_scattering,
                                                 const PathVertex& camera,
                                                 const Scattering& camera_scattering);

/// A light vertex connected to the lens: t = 1. The contribution is to the whole picture: times
/// the number of pixels for the pixel at `raster`.
struct LensConnection {
  Ray shadow_ray;
  Vec2 raster;
  Color contribution;
  float pdf_arrival;   // at the light vertex, of a picture sampled uniformly
  float pdf_backward;  // at the light vertex
  float distance;      // from the lens
};
std::optional<LensConnection> connect_to_lens(const Camera& camera, const PathVertex& vertex,
                                              const Scattering& scattering, Vec2 u_lens);

}  // namespace guidelight

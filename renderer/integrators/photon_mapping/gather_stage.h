#pragma once

#include <vector>

#include "renderer/integrators/photon_mapping/gather_points.h"
#include "renderer/transport/connect.h"

namespace guidelight {

/// What the first stages of a pass have prepared.
struct PhotonMaps {
  PhotonMap global;
  PhotonMap caustic;
  IrradianceMap irradiance;
  IrradianceCache cache;
};

/// The second of the two passes: camera paths that see emitters and scatter sharply; each of their
/// vertices estimates the light of its diffuse scattering, in three disjoint parts: direct light
/// from a point on a light, caustics from the caustic map, all other from a final gather.
class GatherStage {
 public:
  GatherStage(const PhotonMappingPass& setup, const GatheredLight& light, const PhotonMaps& maps);

  void render(const PixelRegion& tile, Film& film);

  // RandomWalk's visitor.
  void escaped(uint32_t index, Subpath& path);
  bool visit(uint32_t index, Subpath& path, const PathVertex& vertex, const Scattering& scattering);
  void end_segment();

 private:
  struct PendingLight {
    uint32_t path;
    int length;
    Color contribution;
  };

  void add(uint32_t index, int length, Color contribution);
  /// Weight of the light that a path meets, by the balance heuristic against add_direct. Densities
  /// per solid angle; `pdf_direct` is 0 where add_direct cannot find it.
  float hit_weight(float pdf, float pdf_direct) const;
  void add_direct(uint32_t index, const PathVertex& vertex, const Scattering& scattering, Rng& rng);
  void add_caustic(uint32_t index, const PathVertex& vertex, const Scattering& scattering);
  void add_indirect(uint32_t index, const PathVertex& vertex, const Scattering& scattering,
                    const Rng& rng);
  /// What the i-th pixel of the tile has seen, by all its paths: they share the pass's photons, and
  /// are one sample.
  FilmSample pixel_sample(size_t i) const;

  const PhotonMappingPass& setup_;
  const PhotonMaps& maps_;
  GatherRule rule_;
  FinalGather gather_;
  RandomWalk walk_;
  PixelRegion tile_;
  std::vector<FilmSample> samples_;  // of each path
  std::vector<PendingLight> pending_;
  std::vector<Ray> shadow_rays_;
  std::vector<uint8_t> blocked_;
};

}  // namespace guidelight

#pragma once

#include <vector>

#include "renderer/photons/hemisphere.h"
#include "renderer/photons/photon_map.h"
#include "renderer/transport/random_walk.h"

namespace guidelight {

/// What gather rays read where they end.
struct GatheredLight {
  const PhotonMap* photons = nullptr;
  const IrradianceMap* irradiance = nullptr;  // null: every ray searches k photons
  EstimateSettings settings;

  /// Radiance that leaves a vertex towards `wo` after diffuse scattering.
  Color radiance(const PathVertex& vertex, const Scattering& scattering) const;

 private:
  /// Whether the irradiance map holds just the light of the allowed path lengths.
  bool serves(int vertex_length) const;
};

/// Final gathering (Jensen 2001, section 8.4): indirect light at a camera vertex, by rays that read
/// photons where they meet a surface that is not a mirror, following those that are. Emitters that
/// they meet are no indirect light and do not count. One object serves many vertices and keeps its
/// memory.
class FinalGather {
 public:
  /// Both must outlive this.
  FinalGather(const Scene& scene, const GatheredLight& light);

  /// Irradiance from about `rays` directions, the hemisphere stratified.
  IrradianceRecord irradiance(const PathVertex& vertex, int rays, Rng rng);

  /// Radiance scattered towards `wo` by any BSDF's diffuse scattering; rays are drawn from it.
  Color radiance(const PathVertex& vertex, const Scattering& scattering, int rays, Rng rng);

  // RandomWalk's visitor.
  void escaped(uint32_t, Subpath&) {}
  bool visit(uint32_t index, Subpath& path, const PathVertex& vertex, const Scattering& scattering);
  void end_segment() {}

 private:
  void clear() { paths_.clear(), samples_.clear(); }
  void add_ray(const PathVertex& vertex, Vec3 direction, Color weight, Rng rng);

  const GatheredLight& light_;
  RandomWalk walk_;
  std::vector<Subpath> paths_;
  std::vector<uint32_t> strata_;             // of the hemisphere, that each path belongs to
  std::vector<Hemisphere::Sample> samples_;  // by path
  int first_length_ = 0;                     // of vertices that gather rays meet first
};

}  // namespace guidelight

#pragma once

#include "renderer/image/tonemap.h"
#include "ui/photons/photon_search.h"
#include "ui/scout/display_mesh.h"

namespace guidelight {

/// The scene's triangles with those that are large divided into equal parts, about `triangles` in
/// all, so that colours can change within a wall.
DisplayMesh subdivided(const DisplayMesh& mesh, size_t triangles);

/// Surfaces in the colours of the density of photons on them.
struct DensityMap {
  DisplayMesh mesh;
  // At the ends of the logarithmic scale, over all but the extremes [photons per scene unit²]; both
  // 0 if there are no photons.
  float low = 0;
  float high = 0;
};
inline constexpr ColorMap kDensityColors = ColorMap::Viridis;

/// `surfaces` must be fine enough for one density per vertex.
DensityMap make_density_map(const DisplayMesh& surfaces, const PhotonSearch& photons);

}  // namespace guidelight

#pragma once

#include <optional>
#include <string>

#include "ui/document.h"
#include "ui/photons/photon_search.h"

namespace guidelight {

/// The photons that an estimate at a point is made of.
struct GatherDisc {
  float radius;      // [scene units]
  std::string text;  // "60 nearest photons within 0.12"
};

/// As the algorithm of the picture would gather at a point: the k nearest, or all within the
/// merging radius of the last pass. Empty for algorithms that gather nothing, and where no photons
/// are.
std::optional<GatherDisc> gather_disc(const Document& document, const PhotonSearch& photons,
                                      const SurfacePoint& point);

/// Of a pixel whose progressive estimate is watched; empty before its first.
std::optional<GatherDisc> progressive_disc(const Document& document, glm::ivec2 pixel);

}  // namespace guidelight

#pragma once

#include <array>
#include <vector>

#include "renderer/photons/photon_cloud.h"
#include "ui/document.h"
#include "ui/gl/point_raster.h"

namespace guidelight {

/// How often which power occurs among photons, over a logarithmic axis.
struct PowerHistogram {
  static constexpr int kBins = 48;
  std::array<float, kBins> counts{};
  float low = 0;  // power at the left and right end [W]
  float high = 0;
};
PowerHistogram power_histogram(const PhotonCloud& cloud);

/// How many of a cloud's photons come from light paths that a guide began.
struct GuideShare {
  int guide;  // position in the list; -1: no guide
  double share;
};
/// The largest first, but those without guide at the end.
std::vector<GuideShare> shares_of_guides(const PhotonCloud& cloud);

/// Display-referred colours that stand for bounces (the first, second, … and all later ones) and
/// kinds (global, caustic).
constexpr int kBounceColors = 6;
Color bounce_color(int bounce);
Color kind_color(bool caustic);
/// The guide's own; grey for none, and for one that is not in the list any more.
Color guided_color(int guide, const std::vector<GuidePath>& guides);

/// The photons as points to draw; `powers` spans the colours of PhotonColoring::Power.
std::vector<PointRaster::Vertex> color_photons(const PhotonCloud& cloud, PhotonColoring coloring,
                                               const PowerHistogram& powers,
                                               const std::vector<GuidePath>& guides);

}  // namespace guidelight

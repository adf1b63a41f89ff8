#include "ui/photons/photon_colors.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "renderer/image/tonemap.h"
#include "ui/widgets.h"

namespace guidelight {
namespace {

constexpr float kTail = 0.01f;  // share of photons beyond either end of the axis

/// Position of a power on the axis, 0 … 1 between its ends.
float share_on_axis(float power, const PowerHistogram& powers) {
  if (!(power > 0)) return 0;
  return std::log(power / powers.low) / std::log(powers.high / powers.low);
}

}  // namespace

PowerHistogram power_histogram(const PhotonCloud& cloud) {
  std::vector<float> sorted;
  sorted.reserve(cloud.points.size());
  for (const auto& point : cloud.points) {
    const float power = luminance(point.power);
    if (power > 0 && std::isfinite(power)) sorted.push_back(power);
  }
  PowerHistogram histogram;
  if (sorted.empty()) return histogram;
  std::ranges::sort(sorted);
  const auto tail = static_cast<size_t>(kTail * static_cast<float>(sorted.size()));
  histogram.low = sorted[tail];
  histogram.high = std::max(sorted[sorted.size() - 1 - tail], 1.01f * histogram.low);
  for (const float power : sorted) {
    const float share = share_on_axis(power, histogram);
    const int bin = static_cast<int>(share * PowerHistogram::kBins);
    ++histogram.counts[std::clamp(bin, 0, PowerHistogram::kBins - 1)];
  }
  return histogram;
}

Color bounce_color(int bounce) {
  // Okabe and Ito 2008, and grey for the rest.
  static const std::array<Color, kBounceColors> kColors = {
      Color(0.94f, 0.89f, 0.26f), Color(0.90f, 0.62f, 0.00f), Color(0.84f, 0.37f, 0.00f),
      Color(0.80f, 0.47f, 0.65f), Color(0.34f, 0.71f, 0.91f), Color(0.65f, 0.65f, 0.68f)};
  return kColors[std::clamp(bounce - 1, 0, kBounceColors - 1)];
}

Color kind_color(bool caustic) {
  return caustic ? Color(1.0f, 0.70f, 0.20f) : Color(0.34f, 0.71f, 0.91f);
}

std::vector<GuideShare> shares_of_guides(const PhotonCloud& cloud) {
  std::map<int, double> counts;
  for (const auto& point : cloud.points) ++counts[point.guide];
  std::vector<GuideShare> shares;
  for (const auto& [guide, count] : counts) {
    shares.push_back({guide, count / static_cast<double>(cloud.points.size())});
  }
  std::ranges::stable_sort(shares, [](const GuideShare& a, const GuideShare& b) {
    if ((a.guide < 0) != (b.guide < 0)) return b.guide < 0;
    return a.share > b.share;
  });
  return shares;
}

Color guided_color(int guide, const std::vector<GuidePath>& guides) {
  const bool is_listed = guide >= 0 && static_cast<size_t>(guide) < guides.size();
  return is_listed ? guides[guide].color : Color(0.55f);
}

std::vector<PointRaster::Vertex> color_photons(const PhotonCloud& cloud, PhotonColoring coloring,
                                               const PowerHistogram& powers,
                                               const std::vector<GuidePath>& guides) {
  std::vector<PointRaster::Vertex> points;
  points.reserve(cloud.points.size());
  for (const auto& photon : cloud.points) {
    Color color;
    switch (coloring) {
      case PhotonColoring::Power:
        color = color_map(ColorMap::Turbo,
                          std::clamp(share_on_axis(luminance(photon.power), powers), 0.0f, 1.0f));
        break;
      case PhotonColoring::Bounce:
        color = bounce_color(photon.bounce);
        break;
      case PhotonColoring::Kind:
        color = kind_color(photon.caustic);
        break;
      case PhotonColoring::Guide:
        color = guided_color(photon.guide, guides);
        break;
    }
    points.push_back({photon.position, to_imgui_color(color)});
  }
  return points;
}

}  // namespace guidelight

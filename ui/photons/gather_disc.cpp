#include "ui/photons/gather_disc.h"

#include <fmt/format.h>

#include <algorithm>

#include "renderer/integrators/bidirectional/pass_setup.h"
#include "renderer/integrators/photon_mapping/settings.h"
#include "ui/format.h"

namespace guidelight {
namespace {

std::optional<GatherDisc> nearest_disc(const PhotonSearch& photons, const SurfacePoint& point,
                                       int k, float farthest) {
  const auto filled =
      photons.radius_of(static_cast<float>(k), point.position, point.geometric_normal);
  if (filled && *filled <= farthest) {
    return GatherDisc{*filled,
                      fmt::format("{} nearest photons within {}", k, format_value(*filled))};
  }
  return GatherDisc{farthest, fmt::format("fewer than {} photons within {}, the search distance", k,
                                          format_value(farthest))};
}

std::optional<GatherDisc> merging_disc(const PhotonSearch& photons, const SurfacePoint& point,
                                       float radius) {
  const float around = photons.density(point.position, point.geometric_normal);
  const float count = around * kPi * radius * radius;
  return GatherDisc{radius, fmt::format("merging radius {}, about {} photons", format_value(radius),
                                        format_count(count))};
}

}  // namespace

std::optional<GatherDisc> gather_disc(const Document& document, const PhotonSearch& photons,
                                      const SurfacePoint& point) {
  const RenderJob& job = document.picture_job();
  const uint32_t pass = std::max(document.picture()->passes, 1u) - 1;
  if (const auto* mapping = dynamic_cast<const PhotonMappingSettings*>(job.settings.get())) {
    const EstimateSettings global = PhotonMappingPass(*job.scene, *mapping, pass, 0).global;
    return nearest_disc(photons, point, global.neighbors, global.max_distance);
  }
  if (const auto* merging = dynamic_cast<const BidirectionalSettings*>(job.settings.get())) {
    if (!merging->merges()) return std::nullopt;
    const MergingRadius radius(*job.scene, *merging, pass, 1, {});
    const Camera& camera = job.scene->camera();
    const float here =
        radius.seen_directly(camera, glm::distance(point.position, camera.position()));
    return merging->merges_nearest() ? nearest_disc(photons, point, merging->neighbors, here)
                                     : merging_disc(photons, point, here);
  }
  return std::nullopt;
}

std::optional<GatherDisc> progressive_disc(const Document& document, glm::ivec2 pixel) {
  const auto history = document.pixel_history(pixel);
  if (history.empty()) return std::nullopt;
  const PixelHistory::Entry& now = history.back();
  return GatherDisc{now.radius, fmt::format("radius {}, {} photons so far",
                                            format_value(now.radius), format_count(now.count))};
}

}  // namespace guidelight

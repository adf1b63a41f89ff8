#pragma once

#include <atomic>
#include <memory>
#include <vector>

#include "renderer/image/pixel_region.h"
#include "renderer/scene/scene.h"
#include "renderer/transport/guide_path.h"

namespace guidelight {

/// A way on which light reaches a part of the picture.
struct HarvestedPath {
  GuidePath guide;   // of the strongest sample: from the light to where the eye's paths begin
  double share = 0;  // of all light that was found, over all samples of this way
};

/// Draws `samples` paths to a region, which must lie within the picture, by all bidirectional
/// techniques and groups those that visit the same shapes; the strongest `count` groups, the
/// strongest first. Directly visible light is left out: no guide leads there. Stops early when told
/// to.
std::vector<HarvestedPath> harvest(const Scene& scene, const PixelRegion& region, int samples,
                                   size_t count, const std::atomic<bool>& stop);

}  // namespace guidelight

#pragma once

#include <atomic>
#include <memory>
#include <vector>

#include "renderer/scene/scene.h"
#include "renderer/transport/guide_path.h"

namespace guidelight {

/// A way on which light reaches a part of the picture.
struct HarvestedPath {
  GuidePath guide;   // of the strongest sample: from the light to where the eye's paths begin
  double share = 0;  // of all light that was found, over all samples of this way
};

/// Pixels of a scene's picture: [first, last).
struct HarvestRegion {
  glm::ivec2 first{0};
  glm::ivec2 last{0};

  static HarvestRegion pixel(glm::ivec2 p) { return {p, p + 1}; }
  bool is_within(const Camera& camera) const {
    return 0 <= first.x && first.x < last.x && last.x <= camera.width() && 0 <= first.y &&
           first.y < last.y && last.y <= camera.height();
  }
};

/// Draws `samples` paths to a region, which must lie within the picture, by all bidirectional
/// techniques and groups those that visit the same shapes; the strongest `count` groups, the
/// strongest first. Directly visible light is left out: no guide leads there. Stops early when told
/// to.
std::vector<HarvestedPath> harvest(const Scene& scene, const HarvestRegion& region, int samples,
                                   size_t count, const std::atomic<bool>& stop);

}  // namespace guidelight

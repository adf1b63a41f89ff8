#pragma once

#include "renderer/parallel/parallel.h"
#include "renderer/scene/ray_log.h"
#include "renderer/scene/scene.h"

namespace guidelight {

/// Numbers of logged rays.
struct RayCounts {
  size_t closest = 0;
  size_t shadow = 0;

  size_t total() const { return closest + shadow; }
};
RayCounts count_rays(const RayLog& log);

/// Traces the rays of a log as they were traced, in packets or one by one, and nothing else: the
/// time that an integrator cannot go below.
void trace_again(const RayLog& log, const Scene& scene, Parallel& parallel);

}  // namespace guidelight

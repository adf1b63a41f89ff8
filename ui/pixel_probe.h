#pragma once

#include <optional>
#include <string>

#include "renderer/scene/scene.h"
#include "renderer/session/snapshot.h"

namespace guidelight {

/// The surface that is seen through the middle of a pixel.
struct SeenSurface {
  std::string shape;
  std::string bsdf;
  Vec3 position;
  float distance;  // [scene units]
  bool emits;
};

/// What is seen through the middle of a pixel of the scene's picture; empty: nothing.
std::optional<SurfacePoint> seen_through_pixel(const Scene& scene, glm::ivec2 pixel);

/// Everything that is known about one pixel.
struct PixelReport {
  int x = 0;  // of the picture at full size
  int y = 0;
  Color radiance{0};
  Color direct{0};
  Color indirect{0};
  Color caustic{0};
  Color connection{0};
  Color merging{0};
  Color albedo{0};
  Vec3 normal{0};
  float depth = 0;
  float samples = 0;
  float standard_error = 0;         // of the luminance of the pixel's mean
  std::optional<SeenSurface> seen;  // empty: the ray leaves the scene
};

/// Reads the layers at a pixel of the full-size picture (a coarse snapshot is read at the matching
/// pixel) and traces a ray through its middle. The camera of `scene` must be that of the picture.
/// Empty outside the picture or before there is one.
std::optional<PixelReport> probe_pixel(const Scene& scene, const Snapshot& snapshot, int x, int y);

}  // namespace guidelight

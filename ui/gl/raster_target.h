#pragma once

#include <imgui.h>

#include "renderer/math/vector.h"

namespace guidelight {

/// A picture that OpenGL draws into, with depth, to be shown by ImGui. Its first row is the upper
/// one. Needs the window's context while it lives.
class RasterTarget {
 public:
  RasterTarget() = default;
  ~RasterTarget();
  RasterTarget(const RasterTarget&) = delete;
  RasterTarget& operator=(const RasterTarget&) = delete;

  /// Everything is drawn into this until end(); the picture is filled with a colour (alpha is kept)
  /// and its depth with infinity.
  void begin(int width, int height, Vec4 background);
  static void end();
  ImTextureID id() const;

 private:
  void resize(int width, int height);

  unsigned framebuffer_ = 0;
  unsigned color_ = 0;
  unsigned depth_ = 0;
  int width_ = 0;
  int height_ = 0;
};

}  // namespace guidelight

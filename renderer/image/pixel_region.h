#pragma once

#include "renderer/image/image.h"

namespace guidelight {

/// Pixels [x0, x1) × [y0, y1) of a picture, from its upper left.
struct PixelRegion {
  int x0 = 0;
  int y0 = 0;
  int x1 = 0;
  int y1 = 0;

  static PixelRegion pixel(glm::ivec2 p) { return {p.x, p.y, p.x + 1, p.y + 1}; }
  static PixelRegion whole(int width, int height) { return {0, 0, width, height}; }

  int width() const { return x1 - x0; }
  int height() const { return y1 - y0; }
  bool empty() const { return x0 >= x1 || y0 >= y1; }
  /// Whether it has pixels, all of a picture of that size.
  bool is_within(int picture_width, int picture_height) const {
    return !empty() && 0 <= x0 && x1 <= picture_width && 0 <= y0 && y1 <= picture_height;
  }

  bool operator==(const PixelRegion&) const = default;
};

/// What two regions share; empty if they share nothing.
PixelRegion intersection(const PixelRegion& a, const PixelRegion& b);

/// A region of an image, which must lie within it.
Image cropped(const Image& image, const PixelRegion& region);

}  // namespace guidelight

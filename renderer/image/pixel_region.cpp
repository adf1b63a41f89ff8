#include "renderer/image/pixel_region.h"

#include <algorithm>

namespace guidelight {

PixelRegion intersection(const PixelRegion& a, const PixelRegion& b) {
  return {std::max(a.x0, b.x0), std::max(a.y0, b.y0), std::min(a.x1, b.x1), std::min(a.y1, b.y1)};
}

Image cropped(const Image& image, const PixelRegion& region) {
  Image part(region.width(), region.height(), image.channels());
  for (int y = 0; y < part.height(); ++y) {
    std::copy_n(image.pixel(region.x0, region.y0 + y),
                static_cast<size_t>(part.width()) * part.channels(), part.pixel(0, y));
  }
  return part;
}

}  // namespace guidelight

#pragma once

#include "renderer/scene/texture.h"

namespace guidelight {

/// An image over the unit square of transformed (u, v); v = 0 is the bottom row.
class BitmapSampler final : public Texture {
 public:
  /// Throws Error if the image is missing or empty. Texels that are not finite become finite.
  explicit BitmapSampler(const BitmapTexture& description);

  Color eval(const SurfacePoint& point) const override;
  float eval_channel(const SurfacePoint& point, int channel) const override;
  Color mean() const override { return mean_; }

 private:
  /// The one or two texels along an axis that a lookup mixes.
  struct AxisLookup {
    int texel[2];
    float weight;  // of the second texel
  };
  static AxisLookup lookup(float coordinate, int size, WrapMode wrap, TextureFilter filter);

  /// Filtered value of read(pixel) at the point.
  template <typename Value, typename Read>
  Value filtered(const SurfacePoint& point, Read read) const;

  BitmapTexture bitmap_;
  Color mean_;
};

}  // namespace guidelight

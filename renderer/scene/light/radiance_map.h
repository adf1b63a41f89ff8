#pragma once

#include <memory>

#include "renderer/image/image.h"
#include "renderer/sampling/distribution.h"

namespace guidelight {

/// An image that emits, interpolated bilinearly between texel centres, with a density to sample it.
/// Coordinates are (x,y)/size from the top left corner. Texels that are negative or NaN count as
/// black, and infinite ones as the largest finite half float or the image's own largest value: an
/// infinite texel is in practice a sun that overflowed its file's number format.
class RadianceMap {
 public:
  enum class Wrap { Repeat, Clamp };  // of x; y is clamped

  /// `row_weight(y)` scales the density of row y: how much of the domain the row stands for.
  RadianceMap(std::shared_ptr<const Image> image, Wrap wrap_x,
              float (*row_weight)(int y, int height));

  Color eval(Vec2 position) const;

  /// Draws a position; pdf per unit area of the square [0,1)². The density is constant over each
  /// texel and proportional to the interpolated luminance's mean there, so it is positive where the
  /// image is.
  GridDistribution::Sample sample(Vec2 u) const { return distribution_.sample(u); }
  float pdf(Vec2 position) const { return distribution_.pdf(position); }

  /// Mean of the texels, each weighted by its row.
  Color mean() const { return mean_; }
  float aspect() const { return static_cast<float>(image_->width()) / image_->height(); }

 private:
  int wrap_x(int x) const;
  int clamp_y(int y) const;

  std::shared_ptr<const Image> image_;
  Wrap wrap_;
  GridDistribution distribution_;
  Color mean_{0};
};

}  // namespace guidelight

#pragma once

#include "renderer/image/image.h"

/// How far a picture is from its reference, on linear values of any range. Nothing is clamped: what
/// has to be left out is counted, and versions robust against outliers stand beside the plain ones.
namespace guidelight {

struct ErrorMeasure {
  double plain = 0;
  double robust = 0;  // without the 0.1 % of pixels that contribute most
};

/// I is the picture, R the reference, Y their luminance; means are over pixels, of colours also
/// over their three channels.
struct ImageMetrics {
  /// √ mean ((Y_I - Y_R) / Y_R)², over pixels with Y_R > 0; the measure of Fan et al. 2005.
  ErrorMeasure rms_relative_error;
  /// mean (I - R)² / (R² + 0.01).
  ErrorMeasure relative_mse;
  /// mean |I - R|.
  ErrorMeasure mean_absolute_error;

  double mean = 0;                // of Y_I
  double reference_mean = 0;      // of Y_R
  double relative_bias = 0;       // mean/reference_mean - 1
  double rms_block_bias = 0;      // of block_bias(), over blocks
  double largest_block_bias = 0;  // its largest magnitude

  size_t pixels = 0;           // compared
  size_t not_finite = 0;       // left out of everything: NaN or infinite in either picture
  size_t black_reference = 0;  // left out of rms_relative_error
};

/// Compares pictures of one size; single channels are grey. Throws Error if the sizes differ or are
/// zero.
ImageMetrics compare_images(const Image& image, const Image& reference);

/// Bias by region: one value per block of 16×16 pixels (less at the right and lower edge), the mean
/// of Y_I over the mean of Y_R, minus 1. Where the reference is black it is 0 or infinite. Pixels
/// that are not finite are left out. Throws Error as compare_images().
Image block_bias(const Image& image, const Image& reference);
inline constexpr int kBiasBlockSize = 16;

/// Each pixel's share of relative_mse, for display; NaN where a pixel is not finite. Throws Error
/// as compare_images().
Image relative_error_map(const Image& image, const Image& reference);

/// Over all pixels; black of an image without any.
Color mean_color(const Image& image);

/// 1 / (relative_mse · seconds): does not depend on the number of samples.
double efficiency(double relative_mse, double seconds);

}  // namespace guidelight

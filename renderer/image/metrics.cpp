#include "renderer/image/metrics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "renderer/error.h"

namespace guidelight {

namespace {

constexpr double kOutlierShare = 0.001;
constexpr double kRelativeMseFloor = 0.01;

void check_sizes(const Image& image, const Image& reference) {
  if (image.empty() || reference.empty()) {
    throw Error("there is no picture to compare: give two pictures with pixels");
  }
  if (image.width() != reference.width() || image.height() != reference.height()) {
    throw Error("pictures of {}x{} and {}x{} pixels cannot be compared: render both at one size",
                image.width(), image.height(), reference.width(), reference.height());
  }
}

/// In double precision: single precision cancels where picture and reference nearly agree.
double luminance_of(Color c) { return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b; }

double relative_squared_error(Color value, Color reference) {
  double sum = 0;
  for (int c = 0; c < 3; ++c) {
    const double r = reference[c];
    sum += sqr(value[c] - r) / (r * r + kRelativeMseFloor);
  }
  return sum / 3;
}

double absolute_error(Color value, Color reference) {
  double sum = 0;
  for (int c = 0; c < 3; ++c) sum += std::abs(static_cast<double>(value[c]) - reference[c]);
  return sum / 3;
}

double mean(std::span<const double> values) {
  if (values.empty()) return 0;
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Means with and without the largest values; reorders them.
ErrorMeasure means(std::vector<double>& values) {
  const auto outliers =
      static_cast<size_t>(std::ceil(kOutlierShare * static_cast<double>(values.size())));
  const size_t kept = values.size() > outliers ? values.size() - outliers : values.size();
  if (kept < values.size()) {
    std::nth_element(values.begin(), values.begin() + static_cast<ptrdiff_t>(kept), values.end());
  }
  return {mean(values), mean(std::span(values).first(kept))};
}

/// Means (or sums) of luminance over one region.
struct RegionMeans {
  double value = 0;
  double reference = 0;
};

double relative_bias(const RegionMeans& means) {
  if (means.reference != 0) return means.value / means.reference - 1;
  return means.value == 0 ? 0 : std::numeric_limits<double>::infinity();
}

}  // namespace

ImageMetrics compare_images(const Image& image, const Image& reference) {
  check_sizes(image, reference);
  ImageMetrics metrics;
  std::vector<double> relative, squared, absolute;
  squared.reserve(image.pixel_count());
  absolute.reserve(image.pixel_count());
  relative.reserve(image.pixel_count());
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const Color i = image.color(x, y);
      const Color r = reference.color(x, y);
      if (!is_finite(i) || !is_finite(r)) {
        ++metrics.not_finite;
        continue;
      }
      const double luminance_i = luminance_of(i);
      const double luminance_r = luminance_of(r);
      metrics.mean += luminance_i;
      metrics.reference_mean += luminance_r;
      squared.push_back(relative_squared_error(i, r));
      absolute.push_back(absolute_error(i, r));
      if (luminance_r > 0) {
        relative.push_back(sqr((luminance_i - luminance_r) / luminance_r));
      } else {
        ++metrics.black_reference;
      }
    }
  }
  metrics.pixels = squared.size();
  if (metrics.pixels == 0) return metrics;
  metrics.mean /= static_cast<double>(metrics.pixels);
  metrics.reference_mean /= static_cast<double>(metrics.pixels);
  metrics.relative_bias = relative_bias({metrics.mean, metrics.reference_mean});
  metrics.relative_mse = means(squared);
  metrics.mean_absolute_error = means(absolute);
  const ErrorMeasure relative_squares = means(relative);
  metrics.rms_relative_error = {std::sqrt(relative_squares.plain),
                                std::sqrt(relative_squares.robust)};

  const Image blocks = block_bias(image, reference);
  double sum = 0;
  for (const float bias : blocks.data()) {
    sum += sqr(static_cast<double>(bias));
    metrics.largest_block_bias =
        std::max(metrics.largest_block_bias, std::abs(static_cast<double>(bias)));
  }
  metrics.rms_block_bias = std::sqrt(sum / static_cast<double>(blocks.pixel_count()));
  return metrics;
}

Image block_bias(const Image& image, const Image& reference) {
  check_sizes(image, reference);
  const auto blocks_along = [](int size) { return (size + kBiasBlockSize - 1) / kBiasBlockSize; };
  Image blocks(blocks_along(image.width()), blocks_along(image.height()), 1);
  std::vector<RegionMeans> sums(blocks.pixel_count());
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const Color i = image.color(x, y);
      const Color r = reference.color(x, y);
      if (!is_finite(i) || !is_finite(r)) continue;
      RegionMeans& block =
          sums[static_cast<size_t>(y / kBiasBlockSize) * blocks.width() + x / kBiasBlockSize];
      block.value += luminance_of(i);
      block.reference += luminance_of(r);
    }
  }
  std::ranges::transform(sums, blocks.data().begin(), [](const RegionMeans& block) {
    return static_cast<float>(relative_bias(block));
  });
  return blocks;
}

Image relative_error_map(const Image& image, const Image& reference) {
  check_sizes(image, reference);
  Image map(image.width(), image.height(), 1);
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const Color i = image.color(x, y);
      const Color r = reference.color(x, y);
      *map.pixel(x, y) = is_finite(i) && is_finite(r)
                             ? static_cast<float>(relative_squared_error(i, r))
                             : std::numeric_limits<float>::quiet_NaN();
    }
  }
  return map;
}

Color mean_color(const Image& image) {
  glm::dvec3 sum(0);
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) sum += glm::dvec3(image.color(x, y));
  }
  return Color(sum / static_cast<double>(std::max<size_t>(image.pixel_count(), 1)));
}

double efficiency(double relative_mse, double seconds) { return 1 / (relative_mse * seconds); }

}  // namespace guidelight

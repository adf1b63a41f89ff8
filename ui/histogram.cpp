#include "ui/histogram.h"

#include <algorithm>

namespace guidelight {
namespace {

int bin_of(float value) {
  const float share =
      (std::log2(value) - Histogram::kMinEv) / (Histogram::kMaxEv - Histogram::kMinEv);
  return std::clamp(static_cast<int>(share * Histogram::kBins), 0, Histogram::kBins - 1);
}

}  // namespace

Histogram make_histogram(const Image& image) {
  Histogram histogram;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const Color color = image.color(x, y);
      if (!is_finite(color)) {
        ++histogram.not_finite;
        continue;
      }
      if (max_component(color) <= 0) ++histogram.zero;
      for (int channel = 0; channel < 3; ++channel) {
        if (color[channel] > 0) ++histogram.counts[channel][bin_of(color[channel])];
      }
    }
  }
  for (const auto& channel : histogram.counts) {
    histogram.tallest = std::max(histogram.tallest, *std::ranges::max_element(channel));
  }
  return histogram;
}

std::pair<float, float> value_range(const Image& image) {
  std::vector<float> values;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) values.push_back(luminance(image.color(x, y)));
  }
  return value_range(std::move(values));
}

std::pair<float, float> value_range(std::vector<float> values) {
  std::erase_if(values, [](float value) { return !std::isfinite(value) || !(value > 0); });
  if (values.empty()) return {0.01f, 1.0f};
  const auto quantile = [&](double share) {
    const auto nth = values.begin() + static_cast<ptrdiff_t>(share * (values.size() - 1));
    std::nth_element(values.begin(), nth, values.end());
    return *nth;
  };
  const float low = quantile(0.01);
  const float high = quantile(0.995);
  if (high > low * 1.01f) return {low, high};
  return {low / 2, high * 2};  // all alike: the middle of the map
}

}  // namespace guidelight

#include "renderer/scene/light/radiance_map.h"

#include <algorithm>
#include <vector>

#include "renderer/error.h"

namespace guidelight {

namespace {

constexpr float kLargestHalf = 65504;

bool is_radiance(float value) { return value >= 0 && value < kInfinity; }

/// The image itself if all its values can be emitted, else a repaired copy.
std::shared_ptr<const Image> repair(std::shared_ptr<const Image> image) {
  if (!image || image->empty()) throw Error("there is no image; give it one that can be read");
  const auto values = image->data();
  if (std::ranges::all_of(values, is_radiance)) return image;
  float largest = kLargestHalf;
  for (const float value : values) {
    if (is_radiance(value)) largest = std::max(largest, value);
  }
  auto repaired = std::make_shared<Image>(*image);
  for (float& value : repaired->data()) {
    if (!is_radiance(value)) value = value == kInfinity ? largest : 0.0f;
  }
  return repaired;
}

}  // namespace

RadianceMap::RadianceMap(std::shared_ptr<const Image> image, Wrap wrap_x_mode,
                         float (*row_weight)(int y, int height))
    : image_(repair(std::move(image))), wrap_(wrap_x_mode) {
  const int width = image_->width();
  const int height = image_->height();
  // A bilinear surface over one texel's square has the mean (1 6 1)/8 ⊗ (1 6 1)/8 of the texels
  // around.
  std::vector<float> across(image_->pixel_count());
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const auto value = [&](int dx) { return luminance(image_->color(wrap_x(x + dx), y)); };
      across[static_cast<size_t>(y) * width + x] = (value(-1) + 6 * value(0) + value(1)) / 8;
    }
  }
  std::vector<float> weights(image_->pixel_count());
  glm::dvec3 sum(0);
  double total_weight = 0;
  for (int y = 0; y < height; ++y) {
    const float weight = row_weight(y, height);
    const float* above = &across[static_cast<size_t>(clamp_y(y - 1)) * width];
    const float* here = &across[static_cast<size_t>(y) * width];
    const float* below = &across[static_cast<size_t>(clamp_y(y + 1)) * width];
    for (int x = 0; x < width; ++x) {
      weights[static_cast<size_t>(y) * width + x] =
          weight * (above[x] + 6 * here[x] + below[x]) / 8;
      sum += static_cast<double>(weight) * glm::dvec3(image_->color(x, y));
    }
    total_weight += static_cast<double>(weight) * width;
  }
  mean_ = Color(sum / total_weight);
  distribution_ = GridDistribution(weights, width, height);
}

int RadianceMap::wrap_x(int x) const {
  const int width = image_->width();
  if (wrap_ == Wrap::Repeat) x = x < 0 ? x + width : x >= width ? x - width : x;
  return std::clamp(x, 0, width - 1);
}

int RadianceMap::clamp_y(int y) const { return std::clamp(y, 0, image_->height() - 1); }

Color RadianceMap::eval(Vec2 position) const {
  const Vec2 texel = position * Vec2(image_->width(), image_->height()) - 0.5f;
  const Vec2 corner = glm::floor(texel);
  const Vec2 share = texel - corner;
  const int x0 = wrap_x(static_cast<int>(corner.x));
  const int x1 = wrap_x(static_cast<int>(corner.x) + 1);
  const int y0 = clamp_y(static_cast<int>(corner.y));
  const int y1 = clamp_y(static_cast<int>(corner.y) + 1);
  const Color top = glm::mix(image_->color(x0, y0), image_->color(x1, y0), share.x);
  const Color bottom = glm::mix(image_->color(x0, y1), image_->color(x1, y1), share.x);
  return glm::mix(top, bottom, share.y);
}

}  // namespace guidelight

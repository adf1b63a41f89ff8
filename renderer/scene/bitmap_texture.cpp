#include "renderer/scene/bitmap_texture.h"

#include <algorithm>

#include "renderer/error.h"
#include "renderer/scene/surface_point.h"

namespace guidelight {
namespace {

// Texel indices that stand for the border of WrapMode::Zero and One.
constexpr int kOutsideZero = -1;
constexpr int kOutsideOne = -2;

constexpr float kLargestTexel =
    65504;  // of half precision: brighter texels were infinite in the file

/// The image itself, or a finite copy of it.
std::shared_ptr<const Image> finite_image(std::shared_ptr<const Image> image) {
  const auto is_finite_value = [](float v) { return std::isfinite(v); };
  if (std::ranges::all_of(image->data(), is_finite_value)) return image;
  auto copy = std::make_shared<Image>(*image);
  for (float& v : copy->data()) {
    v = std::isnan(v) ? 0.0f : std::isinf(v) ? std::copysign(kLargestTexel, v) : v;
  }
  return copy;
}

Color mean_color(const Image& image) {
  glm::dvec3 sum(0.0);
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) sum += glm::dvec3(image.color(x, y));
  }
  return Color(sum / static_cast<double>(image.pixel_count()));
}

/// One channel of a pixel. Grey images repeat their grey; alpha is 1 where there is none.
float channel_value(const float* pixel, int channels, int channel) {
  const bool is_grey = channels <= 2;
  if (channel == 3)
    return is_grey ? (channels == 2 ? pixel[1] : 1.0f) : channels > 3 ? pixel[3] : 1;
  return is_grey ? pixel[0] : pixel[std::clamp(channel, 0, 2)];
}

/// Brings a coordinate near the unit interval, so that texel indices fit an int whatever it was.
float wrap_coordinate(float t, WrapMode wrap) {
  if (!std::isfinite(t)) return 0;
  switch (wrap) {
    case WrapMode::Repeat:
      return t - std::floor(t);
    case WrapMode::Mirror: {
      const float period = t - 2 * std::floor(0.5f * t);
      return period > 1 ? 2 - period : period;
    }
    case WrapMode::Clamp:
      return std::clamp(t, 0.0f, 1.0f);
    default:
      return std::clamp(t, -1.0f, 2.0f);
  }
}

int wrap_texel(int i, int size, WrapMode wrap) {
  if (i >= 0 && i < size) return i;
  if (wrap == WrapMode::Zero) return kOutsideZero;
  if (wrap == WrapMode::One) return kOutsideOne;
  if (wrap == WrapMode::Repeat) return i < 0 ? size - 1 : 0;
  return std::clamp(i, 0, size - 1);  // the mirror's neighbour is the border texel again
}

}  // namespace

BitmapSampler::BitmapSampler(const BitmapTexture& description) : bitmap_(description) {
  if (!bitmap_.image || bitmap_.image->empty()) {
    throw Error("A bitmap texture has no image; give it a readable file.");
  }
  bitmap_.image = finite_image(bitmap_.image);
  mean_ = mean_color(*bitmap_.image);
}

BitmapSampler::AxisLookup BitmapSampler::lookup(float coordinate, int size, WrapMode wrap,
                                                TextureFilter filter) {
  const float t = wrap_coordinate(coordinate, wrap) * size;
  if (filter == TextureFilter::Nearest) {
    // A wrapped coordinate may be exactly 1, the far edge of the last texel.
    const bool is_far_edge = t == size && wrap != WrapMode::Repeat;
    const int i = static_cast<int>(std::floor(t)) - (is_far_edge ? 1 : 0);
    return {{wrap_texel(i, size, wrap), 0}, 0.0f};
  }
  const float first = std::floor(t - 0.5f);
  const int i = static_cast<int>(first);
  return {{wrap_texel(i, size, wrap), wrap_texel(i + 1, size, wrap)}, t - 0.5f - first};
}

template <typename Value, typename Read>
Value BitmapSampler::filtered(const SurfacePoint& point, Read read) const {
  const Vec3 uv = bitmap_.uv_transform * Vec3(point.uv, 1);
  const Image& image = *bitmap_.image;
  const AxisLookup x = lookup(uv.x, image.width(), bitmap_.wrap_u, bitmap_.filter);
  const AxisLookup y = lookup(uv.y, image.height(), bitmap_.wrap_v, bitmap_.filter);
  const auto texel = [&](int column, int row) {  // row 0 is the bottom
    if (column >= 0 && row >= 0) return read(image.pixel(column, image.height() - 1 - row));
    return Value(column == kOutsideZero || row == kOutsideZero ? 0.0f : 1.0f);
  };
  if (bitmap_.filter == TextureFilter::Nearest) return texel(x.texel[0], y.texel[0]);
  const auto row = [&](int r) {
    return (1 - x.weight) * texel(x.texel[0], r) + x.weight * texel(x.texel[1], r);
  };
  return (1 - y.weight) * row(y.texel[0]) + y.weight * row(y.texel[1]);
}

Color BitmapSampler::eval(const SurfacePoint& point) const {
  const int channels = bitmap_.image->channels();
  return filtered<Color>(point, [channels](const float* p) {
    return channels >= 3 ? Color(p[0], p[1], p[2]) : Color(p[0]);
  });
}

float BitmapSampler::eval_channel(const SurfacePoint& point, int channel) const {
  const int channels = bitmap_.image->channels();
  return filtered<float>(
      point, [channels, channel](const float* p) { return channel_value(p, channels, channel); });
}

}  // namespace guidelight

#include "renderer/image/tonemap.h"

#include <algorithm>
#include <array>

namespace guidelight {

namespace {

const Color kClippedColor(1, 0, 0);
const Color kInvalidColor(1, 0, 1);

/// Into [0,1]; NaN becomes 0.
float clamp01(float x) { return x > 0 ? std::min(x, 1.0f) : 0.0f; }
Color clamp01(Color c) { return {clamp01(c.r), clamp01(c.g), clamp01(c.b)}; }

/// IEC 61966-2-1.
float encode_srgb(float x) {
  return x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1 / 2.4f) - 0.055f;
}

float encode(float x, const DisplaySettings& settings) {
  return settings.curve == ToneCurve::Gamma ? std::pow(x, 1 / settings.gamma) : encode_srgb(x);
}

/// Narkowicz 2015, a fit of the Academy's reference rendering transform.
float filmic(float x) { return x * (2.51f * x + 0.03f) / (x * (2.43f * x + 0.59f) + 0.14f); }

/// Reinhard et al. 2002, equation 4, on the luminance.
Color reinhard(Color c, float white) {
  const float y = luminance(c);
  if (!(y > 0)) return Color(0);
  if (y == kInfinity) return Color(kInfinity);
  return c * ((1 + y / sqr(white)) / (1 + y));
}

/// What one pixel turns into before its values are encoded. Everything that does not depend on the
/// pixel is computed once.
class ToneMapper {
 public:
  explicit ToneMapper(const DisplaySettings& settings)
      : settings_(settings),
        scale_(std::exp2(settings.exposure)),
        log_min_(std::log2(settings.false_color_min)),
        inverse_log_range_(1 / std::max(std::log2(settings.false_color_max) - log_min_, 1e-6f)) {}

  bool is_false_color() const { return settings_.curve == ToneCurve::FalseColor; }

  /// Linear display values; above 1 is clipped.
  Color map(Color linear) const {
    const Color c = glm::max(scale_ * linear, Color(0));
    switch (settings_.curve) {
      case ToneCurve::Reinhard:
        return reinhard(c, settings_.reinhard_white);
      case ToneCurve::Filmic:
        return {filmic(c.r), filmic(c.g), filmic(c.b)};
      default:
        return c;
    }
  }

  /// Position in the colour map.
  float false_color_position(Color linear) const {
    return clamp01((std::log2(scale_ * luminance(linear)) - log_min_) * inverse_log_range_);
  }

  /// The mark that show_clipped puts over a pixel, if any.
  const Color* mark(Color linear, Color mapped) const {
    if (!is_finite(linear)) return &kInvalidColor;
    return max_component(mapped) > 1 ? &kClippedColor : nullptr;
  }

 private:
  const DisplaySettings& settings_;
  float scale_;
  float log_min_;
  float inverse_log_range_;
};

/// A function on [0,1] with values in bytes, tabulated over the square root of its argument, in
/// which the encodings of displays are nearly straight: the nearest entry is right to 0.04 of a
/// byte's step.
class ByteTable {
 public:
  template <typename Function>
  explicit ByteTable(Function&& function) {
    for (int i = 0; i < kSize; ++i) {
      const float x = sqr(static_cast<float>(i) / (kSize - 1));
      bytes_[i] = static_cast<uint8_t>(std::lround(255 * clamp01(function(x))));
    }
  }
  uint8_t operator()(float x) const {
    return bytes_[static_cast<int>(std::sqrt(clamp01(x)) * (kSize - 1) + 0.5f)];
  }

 private:
  static constexpr int kSize = 8192;
  std::array<uint8_t, kSize> bytes_;
};

void store(Color c, uint8_t* out) {
  for (int i = 0; i < 3; ++i) out[i] = static_cast<uint8_t>(std::lround(255 * c[i]));
}

/// Calls body(linear colour, output bytes) for all pixels.
template <typename Body>
void for_each_pixel(const Image& image, DisplayImage& out, Body&& body) {
  const int channels = image.channels();
  const int green = channels >= 3 ? 1 : 0;
  const int blue = channels >= 3 ? 2 : 0;
  const float* in = image.data().data();
  uint8_t* bytes = out.rgba.data();
  for (size_t i = 0; i < image.pixel_count(); ++i, in += channels, bytes += 4) {
    body(Color(in[0], in[green], in[blue]), bytes);
    bytes[3] = 255;
  }
}

void display_false_color(const Image& image, const DisplaySettings& settings, DisplayImage& out) {
  constexpr int kSize = 1024;
  std::array<std::array<uint8_t, 3>, kSize> table;
  for (int i = 0; i < kSize; ++i) {
    store(color_map(settings.color_map, static_cast<float>(i) / (kSize - 1)), table[i].data());
  }
  const ToneMapper mapper(settings);
  for_each_pixel(image, out, [&](Color linear, uint8_t* bytes) {
    if (settings.show_clipped && !is_finite(linear)) return store(kInvalidColor, bytes);
    const float position = mapper.false_color_position(linear);
    const auto& entry = table[static_cast<int>(position * (kSize - 1) + 0.5f)];
    std::copy(entry.begin(), entry.end(), bytes);
  });
}

}  // namespace

Color display_color(Color linear, const DisplaySettings& settings) {
  const ToneMapper mapper(settings);
  if (mapper.is_false_color()) {
    if (settings.show_clipped && !is_finite(linear)) return kInvalidColor;
    return color_map(settings.color_map, mapper.false_color_position(linear));
  }
  const Color mapped = mapper.map(linear);
  if (settings.show_clipped) {
    if (const Color* mark = mapper.mark(linear, mapped)) return *mark;
  }
  const Color c = clamp01(mapped);
  return {encode(c.r, settings), encode(c.g, settings), encode(c.b, settings)};
}

void display_image(const Image& image, const DisplaySettings& settings, DisplayImage& out) {
  out.width = image.width();
  out.height = image.height();
  out.rgba.resize(4 * image.pixel_count());
  if (settings.curve == ToneCurve::FalseColor) return display_false_color(image, settings, out);

  const ToneMapper mapper(settings);
  const ByteTable table([&](float x) { return encode(x, settings); });
  for_each_pixel(image, out, [&](Color linear, uint8_t* bytes) {
    const Color mapped = mapper.map(linear);
    if (settings.show_clipped) {
      if (const Color* mark = mapper.mark(linear, mapped)) return store(*mark, bytes);
    }
    for (int c = 0; c < 3; ++c) bytes[c] = table(mapped[c]);
  });
}

float auto_exposure(const Image& image) {
  double sum = 0;
  size_t count = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const float value = luminance(image.color(x, y));
      if (!(value > 0 && value < kInfinity)) continue;  // black and broken pixels say nothing
      sum += std::log2(value);
      ++count;
    }
  }
  constexpr double kLogMiddleGrey = -2.4739311883324122;  // log2(0.18)
  return count > 0 ? static_cast<float>(kLogMiddleGrey - sum / static_cast<double>(count)) : 0.0f;
}

}  // namespace guidelight

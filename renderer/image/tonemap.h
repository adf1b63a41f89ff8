#pragma once

#include "renderer/image/image.h"

namespace guidelight {

enum class ToneCurve { Srgb, Gamma, Reinhard, Filmic, FalseColor };
enum class ColorMap { Viridis, Turbo, Magma };

/// From linear radiance to what a screen shows. One implementation serves the window and the PNG
/// files.
struct DisplaySettings {
  float exposure = 0;  // [EV]: values are multiplied by 2^exposure first
  ToneCurve curve = ToneCurve::Srgb;
  float gamma = 2.2f;  // ToneCurve::Gamma
  float reinhard_white =
      100;  // ToneCurve::Reinhard: smallest luminance shown as white (Reinhard et al. 2002)
  ColorMap color_map = ColorMap::Viridis;
  float false_color_min = 1e-2f;  // ToneCurve::FalseColor, of the luminance, log scale
  float false_color_max = 1e1f;
  bool show_clipped = false;  // marks pixels above white in red, NaN and infinities in magenta

  bool operator==(const DisplaySettings&) const = default;
};

/// Display colour 0..1 of a map at t in [0,1].
Color color_map(ColorMap map, float t);

/// One pixel, linear to display-referred 0..1.
Color display_color(Color linear, const DisplaySettings& settings);

/// A whole picture; `out` is resized. Single-channel images are grey.
void display_image(const Image& image, const DisplaySettings& settings, DisplayImage& out);

/// Exposure [EV] that puts the log-average luminance at middle grey (0.18).
float auto_exposure(const Image& image);

}  // namespace guidelight

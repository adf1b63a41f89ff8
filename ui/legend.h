#pragma once

#include <imgui.h>

#include <string>

#include "ui/picture_developer.h"

namespace guidelight {

/// What the numbers of a layer are measured in; empty if they have no unit.
const char* layer_unit(Layer layer);
/// As in menus: "Sample count".
const char* layer_label(Layer layer);

/// The scale of a false-colour picture: colours, values and unit, in the corner that is given (the
/// lower right one of the view).
/// Returns its width, with the margin.
float draw_legend(ImDrawList& list, Vec2 corner, const Picture& picture);

/// The same for any values on a logarithmic scale, under a heading.
struct ColorScale {
  ColorMap map;
  float low;
  float high;
  std::string heading;
};
float draw_color_scale(ImDrawList& list, Vec2 corner, const ColorScale& scale);

}  // namespace guidelight

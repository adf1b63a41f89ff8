#pragma once

#include <imgui.h>

#include "ui/picture_developer.h"

namespace guidelight {

/// What the numbers of a layer are measured in; empty if they have no unit.
const char* layer_unit(Layer layer);
/// As in menus: "Sample count".
const char* layer_label(Layer layer);

/// The scale of a false-colour picture: colours, values and unit, in the corner that is given (the
/// lower right one of the view).
void draw_legend(ImDrawList& list, Vec2 corner, const Picture& picture);

}  // namespace guidelight

#pragma once

#include <imgui.h>

#include "ui/tools/tool.h"

namespace guidelight {

/// The guides of a document: paths, vertices, what is wrong with them; of the selected one its
/// cones, its disc on the light and paths that it proposes, too.
void draw_guides(const Document& document, const ToolView& view, ImDrawList& list);

/// One guide's path and vertices alone.
void draw_plain_guide(const Document& document, size_t guide, const ToolView& view,
                      ImDrawList& list);

/// The light paths of what was picked, the selected one stronger, and the rectangle if it is one.
void draw_harvest(const Document& document, const ToolView& view, ImDrawList& list);

}  // namespace guidelight

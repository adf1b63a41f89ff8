#pragma once

#include <imgui.h>

#include "ui/tools/tool.h"

namespace guidelight {

/// What both views show of the document besides the scene itself.
void draw_overlays(const Document& document, const ToolView& view, ImDrawList& list);

/// What only makes sense from elsewhere: the lights and the render camera with its frustum.
void draw_lights(const Scene& scene, const ToolView& view, ImDrawList& list);
void draw_render_camera(const Scene& scene, const ToolView& view, ImDrawList& list);

}  // namespace guidelight

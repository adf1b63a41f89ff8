#pragma once

#include <imgui.h>

#include "ui/photons/photon_mapper.h"
#include "ui/tools/tool.h"

namespace guidelight {

/// What both views show of the document besides the scene itself.
/// `photons` may be null.
void draw_overlays(const Document& document, const PhotonKnowledge* photons, const ToolView& view,
                   ImDrawList& list);

/// What only makes sense from elsewhere: the lights and the render camera with its frustum.
void draw_lights(const Scene& scene, const ToolView& view, ImDrawList& list);
void draw_render_camera(const Scene& scene, const ToolView& view, ImDrawList& list);

}  // namespace guidelight

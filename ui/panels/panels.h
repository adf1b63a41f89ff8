#pragma once

#include <functional>
#include <string>

#include "ui/document.h"
#include "ui/key_table.h"
#include "ui/picture_developer.h"
#include "ui/recent_files.h"
#include "ui/render_view.h"
#include "ui/view_layout.h"

/// The panels: each reads the document and sends it edits, none knows another. One file each.
namespace guidelight {

using Perform = std::function<void(Action)>;

void draw_menu_bar(const RecentFiles& recent, const Perform& perform,
                   const std::function<void(const std::string&)>& open_scene, ViewLayout& views);

void draw_scene_panel(const Document& document);
void draw_integrator_panel(Document& document);
void draw_render_panel(Document& document, bool region_tool_active, int& autosave_minutes,
                       const Perform& perform);

void draw_image_panel(Document& document, const Perform& perform);
/// `picture` may be null.
void draw_histogram_panel(const Document& document, const Picture* picture);
/// Shows the picked pixel, else the one under the mouse.
void draw_inspector_panel(Document& document, std::optional<glm::ivec2> hovered);

/// `loading` names the scene that is being read; empty if there is none.
void draw_status_bar(const Document& document, const RenderView& view, const std::string& loading);

/// Messages in the lower left corner of the view, newest at the bottom.
void draw_messages(Messages& messages, ImVec2 corner, float width);

/// All keys, over the window, until it is clicked away.
void draw_key_sheet(bool& open);

}  // namespace guidelight

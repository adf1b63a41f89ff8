#pragma once

#include <functional>
#include <string>

#include "ui/compare/comparison.h"
#include "ui/document.h"
#include "ui/key_table.h"
#include "ui/photons/photon_colors.h"
#include "ui/picture_developer.h"
#include "ui/recent_files.h"
#include "ui/render_view.h"
#include "ui/view_layout.h"

/// The panels: each reads the document and sends it edits, none knows another. One file each.
namespace guidelight {

using Perform = std::function<void(Action)>;

/// Why an action makes no sense at the moment; empty if it does.
std::string why_disabled(Action action, const Document& document);
/// As in menus, with what exactly would be undone.
std::string menu_label(Action action, const Document& document);

void draw_menu_bar(const Document& document, const RecentFiles& recent, const Perform& perform,
                   const std::function<void(const std::string&)>& open_scene, ViewLayout& views);

void draw_scene_panel(const Document& document);
/// A row with a parameter's widget; returns whether its value was changed.
bool draw_parameter(const Parameter& parameter);
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

/// The list of guide paths and what can be set of the selected one.
void draw_guides_panel(Document& document, bool tool_active, const std::string& file,
                       const Perform& perform);

/// What photons there are, and how they are shown.
void draw_photons_panel(Document& document, const PowerHistogram& powers);

/// What the render is compared with, and how far it is from it.
void draw_compare_panel(const Document& document, Comparison& comparison, const Perform& perform);

/// Messages in the lower left corner of the view, newest at the bottom.
void draw_messages(Messages& messages, ImVec2 corner, float width);

/// All keys, over the window, until it is clicked away.
void draw_key_sheet(bool& open);

}  // namespace guidelight

#pragma once

#include <functional>
#include <string>

#include "ui/compare/comparison.h"
#include "ui/display_scene.h"
#include "ui/document.h"
#include "ui/key_table.h"
#include "ui/picture_developer.h"
#include "ui/recent_files.h"
#include "ui/view_layout.h"

/// The panels: each reads the document and sends it edits, none knows another. One file each.
namespace guidelight {

using Perform = std::function<void(Action)>;

/// Why an action makes no sense at the moment; empty if it does.
std::string why_disabled(Action action, const Document& document);
/// As in menus, with what exactly would be undone.
std::string menu_label(Action action, const Document& document);

/// A button for an action, in the accent colour while `on`, with its key in the tooltip; disabled,
/// with the reason there instead, where the action makes no sense.
void action_button(const char* label, Action action, bool on, float width, const Document& document,
                   const Perform& perform);

void draw_menu_bar(const Document& document, const RecentFiles& recent, const Perform& perform,
                   const std::function<void(const std::string&)>& open_scene, ViewLayout& views);

/// Pause, restart and the tool for a render region.
void draw_render_commands(const Document& document, bool region_tool_active,
                          const Perform& perform);
/// Where the fields of the next three panels begin, as in row(), so that they stand below each
/// other and every label fits.
float settings_column(const std::vector<Parameter>& parameters);
void draw_scene_panel(const Document& document, float column);
/// A row with a parameter's widget; returns whether its value was changed. `column` as in row().
bool draw_parameter(const Parameter& parameter, float column = 0);
/// A choice as it is shown: "own_path" is "own path".
std::string choice_text(std::string name);
void draw_integrator_panel(Document& document, float column);
void draw_render_panel(Document& document, int& autosave_minutes, float column);

/// How far the render is, how fast it goes, and how its Markov chains fare.
void draw_statistics_panel(const Document& document);

void draw_image_panel(Document& document, const Perform& perform);
/// `picture` may be null.
void draw_histogram_panel(const Document& document, const Picture* picture);
/// Shows the picked pixel, else the one under the mouse.
void draw_inspector_panel(Document& document);

/// Whether techniques are recorded, and how they are shown.
void draw_techniques_panel(Document& document, const Perform& perform);

/// `zoom`: screen pixels per pixel of the picture. `loading` names the scene that is being read;
/// empty if there is none.
void draw_status_bar(const Document& document, float zoom, const std::string& loading);

/// Which tools of the Guides tab are in hand.
struct ToolsHeld {
  bool guide = false;
  bool harvest = false;
};
/// The list of guide paths, what can be set of the selected one, and what helps to find others.
void draw_guides_panel(Document& document, const ToolsHeld& tools, const std::string& file,
                       const Perform& perform);
/// How the Markov chains fare with each guide.
void draw_guide_statistics(Document& document);
/// The light paths of the picked pixel or rectangle.
void draw_harvest_panel(Document& document, bool tool_held, const Perform& perform);

/// What photons there are, and how they are shown.
void draw_photons_panel(Document& document, const DisplayScene& display);

/// What the render is compared with, and how far it is from it.
void draw_compare_panel(const Document& document, Comparison& comparison, const Perform& perform);

/// Messages in the lower left corner of the view, newest at the bottom.
void draw_messages(Messages& messages, ImVec2 corner, float width);

/// All keys, over the window, until it is clicked away.
void draw_key_sheet(bool& open);

}  // namespace guidelight

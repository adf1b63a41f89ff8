#pragma once

#include <imgui.h>

#include <string>
#include <vector>

#include "renderer/math/vector.h"

/// The few building blocks that all panels are made of.
namespace guidelight {

inline ImVec2 to_imgui(Vec2 v) { return {v.x, v.y}; }
inline Vec2 from_imgui(ImVec2 v) { return {v.x, v.y}; }

/// A display-referred colour, red in the lowest byte.
ImU32 to_imgui_color(Color display_color, float alpha = 1);
/// The same colour with its opacity multiplied.
ImU32 faded(ImU32 color, float factor);

/// Lengths are given for scale 1 and follow the font.
float scaled(float length);

/// A heading that opens and closes what follows; returns whether it is open.
bool section(const char* title);

/// Begins a row: the label on the left with a tooltip, the next widget fills the right. `column`:
/// where the right begins, from the left edge; 0 for the usual share of the width, or for the
/// label's own if it is longer. A label is shortened only if it does not fit into `column`.
void row(const char* label, const std::string& help = "", float column = 0);
/// Where it begins so that the fields of all these labels stand below each other: at `least_share`
/// of the width, or as far to the right as they need, at most at half of it.
float label_column(const std::vector<std::string>& labels, float least_share);

/// A number as its field shows it: 1, "segments" → "1 segment".
std::string number_text(int value, const std::string& unit);
std::string number_text(float value, const std::string& unit);
/// The room for text in a field of that width.
float room_in_field(float width);

/// A number that is dragged, or typed after a double click, with its unit behind it where there is
/// room for both. Each returns whether the value was changed; it stays within the limits.
bool number(const char* id, int& value, int low, int high, const std::string& unit);
bool number(const char* id, float& value, float low, float high, const std::string& unit,
            bool logarithmic = false);

/// A row that shows a value; too long values are shortened in the middle, the tooltip has them
/// whole.
void readout(const char* label, const std::string& value, const std::string& help = "",
             float column = 0);

/// A row with a bar that is filled to a share, 0 … 1, and what it says on it.
void share_bar(const char* label, float share, const std::string& value, const std::string& help);

void dim_text(const std::string& text);
void wrapped_dim_text(const std::string& text);
/// Explains the widget before it when the mouse rests there.
void tooltip(const std::string& text);
/// Closes lists and menus that are open; false if there are none. Dialogs are left alone.
bool close_lists();

/// A button in the accent colour while `on`.
bool toggle_button(const char* label, bool on, ImVec2 size = {0, 0});

/// Text around a point of the screen.
void centered_text(ImDrawList& list, Vec2 center, ImU32 color, const std::string& text);
/// Text on a dark ground, long one in several lines, moved so that all of it lies within the clip
/// rectangle.
void draw_note(ImDrawList& list, Vec2 corner, const std::string& text,
               ImU32 ground = IM_COL32(20, 20, 20, 225),
               ImU32 color = IM_COL32(222, 222, 224, 255));
/// Text around a point, on a dark pill.
void draw_hint(ImDrawList& list, Vec2 center, const std::string& text);

/// The text, or its beginning and end around "…", so that it is no wider than `width`.
std::string shortened(const std::string& text, float width);

}  // namespace guidelight

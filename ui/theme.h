#pragma once

#include <imgui.h>

namespace guidelight {

/// The colours of the interface: neutral greys, so that they do not tint the judgement of a
/// picture, and one accent.
namespace palette {
inline constexpr ImU32 kBackdrop = IM_COL32(24, 24, 24, 255);  // around the picture
inline constexpr ImU32 kPanel = IM_COL32(34, 34, 35, 255);
inline constexpr ImU32 kRaised = IM_COL32(44, 44, 46, 255);  // menus, dialogs, toasts
inline constexpr ImU32 kField = IM_COL32(54, 54, 57, 255);
inline constexpr ImU32 kFieldHovered = IM_COL32(66, 66, 70, 255);
inline constexpr ImU32 kLine = IM_COL32(58, 58, 61, 255);
inline constexpr ImU32 kText = IM_COL32(222, 222, 224, 255);
inline constexpr ImU32 kDim = IM_COL32(150, 150, 155, 255);
inline constexpr ImU32 kAccent = IM_COL32(232, 168, 76, 255);  // lamplight
inline constexpr ImU32 kAccentSoft = IM_COL32(232, 168, 76, 90);
inline constexpr ImU32 kOnAccent = IM_COL32(28, 22, 12, 255);
inline constexpr ImU32 kNote = IM_COL32(118, 170, 130, 255);
inline constexpr ImU32 kWarning = IM_COL32(232, 168, 76, 255);
inline constexpr ImU32 kError = IM_COL32(229, 83, 75, 255);
}  // namespace palette

/// Of the font at scale 1 [pixels]; all lengths follow it.
inline constexpr float kBodySize = 16;

/// Sets colours, spacing and rounding for a scale of the interface; 1 is meant for 96 dots per
/// inch.
void apply_theme(float scale);

/// Fills ImGui's font atlas: Inter, else DejaVu Sans, else ImGui's own. Digits get the same width
/// so that changing numbers stand still. The caller recreates the font texture.
void load_fonts(float scale);
/// The heavier font for headings; the body's is ImGui's default.
ImFont* heading_font();

}  // namespace guidelight

#include "ui/layout.h"

#include <algorithm>

#include "ui/theme.h"
#include "ui/widgets.h"

namespace guidelight {
namespace {

constexpr float kNarrowest = 230;      // of a column, at scale 1
constexpr float kNarrowestView = 240;  // at scale 1

}  // namespace

void Layout::update(bool panels_shown, float menu_height) {
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  if (!panels_shown) {
    left_ = right_ = status_ = {};
    view_ = {{0, 0}, window};
    return;
  }
  const float status_height = ImGui::GetTextLineHeight() + scaled(16);
  const float height = std::max(1.0f, window.y - menu_height - status_height);
  const float room = window.x - scaled(kNarrowestView);
  const float left = std::min(scaled(left_width_), room / 2);
  const float right = std::min(scaled(right_width_), room / 2);
  left_ = {{0, menu_height}, {left, height}};
  view_ = {{left, menu_height}, {window.x - left - right, height}};
  right_ = {{window.x - right, menu_height}, {right, height}};
  status_ = {{0, window.y - status_height}, {window.x, status_height}};
  drag_border("left border", left, left_width_, 1);
  drag_border("right border", window.x - right, right_width_, -1);
}

/// Direction 1 makes the column wider to the right.
void Layout::drag_border(const char* name, float x, float& width, float direction) {
  const float moved = drag_vertical_border(name, view_, x - view_.corner.x);
  if (moved == 0) return;
  const float widest = (ImGui::GetIO().DisplaySize.x / scaled(1) - kNarrowestView) / 2;
  width += direction * moved / scaled(1);
  width = std::clamp(width, kNarrowest, std::max(kNarrowest, widest));
}

/// An invisible strip over the border.
float drag_vertical_border(const char* name, const Area& area, float x) {
  const float half = scaled(4);
  x += area.corner.x;
  ImGui::SetNextWindowPos({x - half, area.corner.y});
  ImGui::SetNextWindowSize({2 * half, area.size.y});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
  ImGui::Begin(name, nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoBackground |
                   ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings);
  ImGui::InvisibleButton("drag", {2 * half, area.size.y});
  const bool lit = ImGui::IsItemHovered() || ImGui::IsItemActive();
  if (lit) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  const float moved = ImGui::IsItemActive() ? ImGui::GetIO().MouseDelta.x : 0;
  const float line = std::max(1.0f, scaled(lit ? 2 : 1));
  ImGui::GetWindowDrawList()->AddRectFilled({x - line / 2, area.corner.y},
                                            {x + line / 2, area.corner.y + area.size.y},
                                            lit ? palette::kAccent : palette::kLine);
  ImGui::End();
  ImGui::PopStyleVar(2);
  return moved;
}

void begin_area(const char* name, const Area& area, Padding padding, ImU32 background) {
  ImGui::SetNextWindowPos(area.corner);
  ImGui::SetNextWindowSize(area.size);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
  const ImVec2 room = padding == Padding::None  ? ImVec2(0, 0)
                      : padding == Padding::Bar ? ImVec2(scaled(14), scaled(8))
                                                : ImGui::GetStyle().WindowPadding;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, room);
  ImGui::PushStyleColor(ImGuiCol_WindowBg, background);
  const int scrolling = padding == Padding::Panel
                            ? 0
                            : ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse;
  ImGui::Begin(name, nullptr,
               scrolling | ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                   ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                   ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoSavedSettings);
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(2);
}

}  // namespace guidelight

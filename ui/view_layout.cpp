#include "ui/view_layout.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "ui/key_table.h"
#include "ui/widgets.h"

namespace guidelight {
namespace {

constexpr float kSmallestShare = 0.15f;

}  // namespace

void ViewLayout::cycle() { shown_ = static_cast<ShownViews>((static_cast<int>(shown_) + 1) % 3); }

void ViewLayout::update(const Area& room) {
  render_ = scout_ = room;
  if (shown_ != ShownViews::Both) return;
  const float moved = drag_vertical_border("views border", room, room.size.x * render_share_);
  render_share_ = std::clamp(render_share_ + moved / std::max(1.0f, room.size.x), kSmallestShare,
                             1 - kSmallestShare);
  const float width = std::round(room.size.x * render_share_);
  render_.size.x = width;
  scout_.corner.x += width;
  scout_.size.x -= width;
}

void ViewLayout::draw_buttons() {
  static constexpr std::array kViews = {
      std::pair{"Render", "The picture through the render camera"},
      std::pair{"Scout", "The scene through a camera of its own, drawn at once"},
      std::pair{"Both", "Both views side by side"}};
  const ImVec2 padding = {ImGui::GetStyle().FramePadding.x, scaled(2)};
  const float gap = scaled(2);
  float width = -gap;
  for (const auto& [label, help] : kViews) {
    width += ImGui::CalcTextSize(label).x + 2 * padding.x + gap;
  }
  const float margin = (ImGui::GetFrameHeight() - ImGui::GetTextLineHeight()) / 2 - padding.y;
  ImGui::SetCursorPos({ImGui::GetWindowWidth() - width - scaled(6), margin});
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, padding);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {gap, 0});
  for (int i = 0; i < static_cast<int>(kViews.size()); ++i) {
    const auto views = static_cast<ShownViews>(i);
    if (toggle_button(kViews[i].first, shown_ == views)) shown_ = views;
    tooltip(std::string(kViews[i].second) + " (" + shortcut_text(Action::CycleViews) + ")");
  }
  ImGui::PopStyleVar(2);
}

}  // namespace guidelight

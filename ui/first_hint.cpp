#include "ui/first_hint.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include "renderer/io/atomic_file.h"
#include "ui/key_table.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace guidelight {

FirstHint::FirstHint(const std::string& state_folder) : mark_(state_folder + "/guide-tool-known") {
  std::error_code unreadable;  // a folder that cannot be looked into has no mark
  shown_ = !std::filesystem::exists(mark_, unreadable);
}

void FirstHint::dismiss() {
  if (!shown_) return;
  shown_ = false;
  try {
    std::filesystem::create_directories(std::filesystem::path(mark_).parent_path());
    write_file_atomically(mark_, "");
  } catch (const std::exception&) {
    // The hint then comes once more, which is not worth a message.
  }
}

void FirstHint::draw(Vec2 corner, float room) {
  if (!shown_) return;
  const std::array lines = {"1   Press " + shortcut_text(Action::NewGuide) + " and click a light.",
                            std::string("2   Click the surfaces that its light should reach."),
                            "3   Enter ends the path. " + shortcut_text(Action::CycleViews) +
                                " shows the scene from elsewhere."};
  const std::string title = "Show light the way";
  const float height = ImGui::GetTextLineHeightWithSpacing();
  float width = 0;
  for (const std::string& line : lines) {
    width = std::max(width, ImGui::CalcTextSize(line.c_str()).x);
  }
  const Vec2 pad(scaled(14), scaled(10));
  const Vec2 low = corner + scaled(12);
  if (width + 2 * pad.x + scaled(24) > room) return;
  const Vec2 size(width, height * static_cast<float>(lines.size() + 1));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(to_imgui(low), to_imgui(low + size + 2.0f * pad), IM_COL32(24, 24, 24, 225),
                     scaled(6));
  list.AddRectFilled(to_imgui(low), to_imgui(low + Vec2(scaled(3), size.y + 2 * pad.y)),
                     palette::kAccent, scaled(2));
  Vec2 at = low + pad;
  list.AddText(heading_font(), ImGui::GetFontSize(), to_imgui(at), palette::kText, title.c_str());
  for (const std::string& line : lines) {
    at.y += height;
    list.AddText(to_imgui(at), palette::kDim, line.c_str());
  }
  if (draw_cross({low.x + size.x + 2 * pad.x, low.y})) dismiss();
}

/// Returns whether it was clicked.
bool FirstHint::draw_cross(Vec2 upper_right) const {
  const float side = ImGui::GetFrameHeight();
  const Vec2 corner = upper_right + Vec2(-side - scaled(3), scaled(3));
  ImGui::SetCursorScreenPos(to_imgui(corner));
  const bool clicked = ImGui::InvisibleButton("dismiss the hint", {side, side});
  const ImU32 color = ImGui::IsItemHovered() ? palette::kText : palette::kDim;
  centered_text(*ImGui::GetWindowDrawList(), corner + 0.5f * side, color, "×");
  tooltip("Do not show this again");
  return clicked;
}

}  // namespace guidelight

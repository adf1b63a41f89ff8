#include <algorithm>
#include <vector>

#include "ui/panels/panels.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace guidelight {
namespace {

struct Entry {
  std::string keys;
  std::string label;
};

/// The key table by its groups, in the order of the table.
std::vector<std::pair<std::string, std::vector<Entry>>> grouped_entries() {
  std::vector<std::pair<std::string, std::vector<Entry>>> groups;
  const auto group_named = [&](const char* name) -> std::vector<Entry>& {
    for (auto& [title, entries] : groups) {
      if (title == name) return entries;
    }
    groups.push_back({name, {}});
    return groups.back().second;
  };
  for (const KeyBinding& binding : key_bindings()) {
    group_named(binding.group).push_back({key_text(binding.key, binding.modifiers), binding.label});
  }
  for (const MouseBinding& binding : mouse_bindings()) {
    group_named(binding.group).push_back({mouse_text(binding), binding.label});
  }
  group_named("Image").push_back({"hold Shift", "The compared picture alone"});
  auto& tools = group_named("While a path is placed");
  for (const ToolKey& key : tool_keys()) {
    if (key.label) tools.push_back({key_text(key.key, 0), key.label});
  }
  auto& flying = group_named("While the right button is held");
  for (const FlyKey& key : fly_keys()) flying.push_back({key_text(key.key, 0), key.label});
  flying.push_back({"Shift, Ctrl", "fast, slow"});
  flying.push_back({"wheel", "speed"});
  return groups;
}

void draw_group(const std::string& title, const std::vector<Entry>& entries) {
  constexpr float kNarrowest = 84;  // so that most groups are aligned
  constexpr float kGap = 14;
  float keys = scaled(kNarrowest);
  for (const Entry& entry : entries) {
    keys = std::max(keys, ImGui::CalcTextSize(entry.keys.c_str()).x + scaled(kGap));
  }
  ImGui::PushFont(heading_font());
  ImGui::TextUnformatted(title.c_str());
  ImGui::PopFont();
  const float left = ImGui::GetCursorPosX();
  for (const Entry& entry : entries) {
    ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(palette::kAccent), "%s", entry.keys.c_str());
    ImGui::SameLine();
    ImGui::SetCursorPosX(left + keys);
    ImGui::TextUnformatted(entry.label.c_str());
  }
  ImGui::Dummy({0, scaled(8)});
}

/// In as many columns as there is room for, of about the same height.
void draw_groups() {
  constexpr float kWidest = 296;  // of a group, at scale 1
  constexpr int kMostColumns = 4;
  constexpr size_t kHeading = 2;  // lines
  const auto groups = grouped_entries();
  const auto room = static_cast<int>(ImGui::GetContentRegionAvail().x / scaled(kWidest));
  const auto columns = static_cast<size_t>(std::clamp(room, 1, kMostColumns));
  size_t lines = 0;
  for (const auto& [title, entries] : groups) lines += kHeading + entries.size();
  ImGui::Columns(static_cast<int>(columns), "groups", false);
  size_t drawn = 0;
  size_t column = 1;
  for (const auto& [title, entries] : groups) {
    const size_t height = kHeading + entries.size();
    if (columns * (drawn + height / 2) > column * lines) {
      ImGui::NextColumn();
      ++column;
    }
    draw_group(title, entries);
    drawn += height;
  }
  ImGui::Columns(1);
}

}  // namespace

void draw_key_sheet(bool& open) {
  constexpr const char* kTitle = "Keys";
  if (open && !ImGui::IsPopupOpen(kTitle)) ImGui::OpenPopup(kTitle);
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({screen.x / 2, screen.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSize({std::min(scaled(1240), screen.x * 0.96f), 0});
  if (!ImGui::BeginPopupModal(kTitle, &open, ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove)) {
    return;
  }
  draw_groups();
  const bool clicked_outside =
      ImGui::IsMouseClicked(ImGuiMouseButton_Left) && !ImGui::IsWindowHovered();
  if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape)) || clicked_outside) open = false;
  if (!open) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
}

}  // namespace guidelight

#include <cstring>
#include <map>
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
  ImGui::PushFont(heading_font());
  ImGui::TextUnformatted(title.c_str());
  ImGui::PopFont();
  if (!ImGui::BeginTable(title.c_str(), 2)) return;
  ImGui::TableSetupColumn("keys", ImGuiTableColumnFlags_WidthFixed, scaled(135));
  ImGui::TableSetupColumn("label");
  for (const Entry& entry : entries) {
    ImGui::TableNextColumn();
    ImGui::PushStyleColor(ImGuiCol_Text, palette::kAccent);
    ImGui::TextUnformatted(entry.keys.c_str());
    ImGui::PopStyleColor();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(entry.label.c_str());
  }
  ImGui::EndTable();
  ImGui::Dummy({0, scaled(6)});
}

}  // namespace

void draw_key_sheet(bool& open) {
  constexpr const char* kTitle = "Keys";
  if (open && !ImGui::IsPopupOpen(kTitle)) ImGui::OpenPopup(kTitle);
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({screen.x / 2, screen.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSize({std::min(scaled(1080), screen.x * 0.96f), 0});
  if (!ImGui::BeginPopupModal(kTitle, &open, ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove)) {
    return;
  }
  const auto groups = grouped_entries();
  ImGui::Columns(3, "groups", false);
  for (size_t i = 0; i < groups.size(); ++i) {
    draw_group(groups[i].first, groups[i].second);
    if (i % 2 == 1 && i + 1 < groups.size()) ImGui::NextColumn();
  }
  ImGui::Columns(1);
  const bool clicked_outside =
      ImGui::IsMouseClicked(ImGuiMouseButton_Left) && !ImGui::IsWindowHovered();
  if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape)) || clicked_outside) open = false;
  if (!open) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
}

}  // namespace guidelight

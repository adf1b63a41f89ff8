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

struct Group {
  std::string title;
  std::vector<Entry> entries;

  size_t lines() const { return entries.size() + 2; }  // with its title and a gap
};

/// Groups below each other, and the room that they take.
struct Column {
  std::vector<Group> groups;
  float keys = 0;  // width, with a gap
  float labels = 0;

  void add(const Group& group) {
    constexpr float kGap = 14;
    groups.push_back(group);
    for (const Entry& entry : group.entries) {
      keys = std::max(keys, ImGui::CalcTextSize(entry.keys.c_str()).x + scaled(kGap));
      labels = std::max(labels, ImGui::CalcTextSize(entry.label.c_str()).x);
    }
  }
  float width() const { return keys + labels; }
};

/// The key table by its groups, in the order of the table.
std::vector<Group> grouped_entries() {
  std::vector<Group> groups;
  const auto group_named = [&](const char* name) -> std::vector<Entry>& {
    for (Group& group : groups) {
      if (group.title == name) return group.entries;
    }
    groups.push_back({name, {}});
    return groups.back().entries;
  };
  for (const KeyBinding& binding : key_bindings()) {
    group_named(binding.group).push_back({key_text(binding.key, binding.modifiers), binding.label});
  }
  for (const MouseBinding& binding : mouse_bindings()) {
    group_named(binding.group).push_back({mouse_text(binding), binding.label});
  }
  group_named("Image").push_back({"hold Shift", "The other picture alone"});
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

/// So many columns of about the same height.
std::vector<Column> in_columns(const std::vector<Group>& groups, size_t count) {
  size_t lines = 0;
  for (const Group& group : groups) lines += group.lines();
  std::vector<Column> columns(1);
  size_t placed = 0;
  for (const Group& group : groups) {
    if (count * (placed + group.lines() / 2) > columns.size() * lines) columns.emplace_back();
    columns.back().add(group);
    placed += group.lines();
  }
  return columns;
}

constexpr float kGapOfColumns = 26;

float width_of(const std::vector<Column>& columns) {
  float width = scaled(kGapOfColumns) * static_cast<float>(columns.size() - 1);
  for (const Column& column : columns) width += column.width();
  return width;
}

/// As many columns as there is room for.
std::vector<Column> fitting_columns(float room) {
  const std::vector<Group> groups = grouped_entries();
  for (size_t count = 4; count > 1; --count) {
    std::vector<Column> columns = in_columns(groups, count);
    if (width_of(columns) <= room) return columns;
  }
  return in_columns(groups, 1);
}

void draw_group(const Group& group, float keys) {
  ImGui::PushFont(heading_font());
  ImGui::TextUnformatted(group.title.c_str());
  ImGui::PopFont();
  const float left = ImGui::GetCursorPosX();
  for (const Entry& entry : group.entries) {
    ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(palette::kAccent), "%s", entry.keys.c_str());
    ImGui::SameLine();
    ImGui::SetCursorPosX(left + keys);
    ImGui::TextUnformatted(entry.label.c_str());
  }
  ImGui::Dummy({0, scaled(8)});
}

void draw_columns(const std::vector<Column>& columns) {
  float left = ImGui::GetCursorPosX();
  for (const Column& column : columns) {
    ImGui::SetCursorPosX(left);
    ImGui::BeginGroup();
    for (const Group& group : column.groups) draw_group(group, column.keys);
    ImGui::EndGroup();
    left += column.width() + scaled(kGapOfColumns);
    if (&column != &columns.back()) ImGui::SameLine();
  }
}

}  // namespace

void draw_key_sheet(bool& open) {
  constexpr const char* kTitle = "Keys";
  if (open && !ImGui::IsPopupOpen(kTitle)) ImGui::OpenPopup(kTitle);
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({screen.x / 2, screen.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
  const float borders = 2 * ImGui::GetStyle().WindowPadding.x + ImGui::GetStyle().ScrollbarSize;
  const std::vector<Column> columns = fitting_columns(0.98f * screen.x - borders);
  ImGui::SetNextWindowSize({width_of(columns) + borders, 0});
  if (!ImGui::BeginPopupModal(kTitle, &open, ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove)) {
    return;
  }
  draw_columns(columns);
  const bool clicked_outside =
      ImGui::IsMouseClicked(ImGuiMouseButton_Left) && !ImGui::IsWindowHovered();
  if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape)) || clicked_outside) open = false;
  if (!open) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
}

}  // namespace guidelight

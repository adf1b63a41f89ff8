#include "ui/panels/open_dialog.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <utility>

#include "ui/theme.h"
#include "ui/widgets.h"

namespace guidelight {
namespace {

namespace fs = std::filesystem;

constexpr const char* kTitle = "Open scene";

bool pressed(ImGuiKey key) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key)); }

std::string lower_case(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

}  // namespace

bool looks_like_scene(const fs::path& path) {
  const std::string extension = lower_case(path.extension().string());
  return extension == ".xml" || extension == ".gltf" || extension == ".glb";
}

void OpenDialog::open(const std::string& folder) {
  open_ = true;
  focus_path_ = true;
  chosen_.clear();
  std::error_code ignored;
  enter(folder.empty() ? fs::current_path(ignored) : fs::path(folder));
}

void OpenDialog::enter(const fs::path& folder) {
  std::error_code failure;
  std::vector<Entry> entries;
  for (auto entry = fs::directory_iterator(folder, failure); !failure && entry != fs::end(entry);
       entry.increment(failure)) {
    std::error_code ignored;
    const std::string name = entry->path().filename().string();
    const bool is_folder = entry->is_directory(ignored);
    if (name.starts_with(".") || (!is_folder && !looks_like_scene(name))) continue;
    entries.push_back({name, is_folder});
  }
  if (failure) {
    problem_ = "Cannot read " + folder.string() + ": " + failure.message();
    return;
  }
  std::ranges::sort(entries, [](const Entry& a, const Entry& b) {
    if (a.is_folder != b.is_folder) return a.is_folder;
    return lower_case(a.name) < lower_case(b.name);
  });
  folder_ = folder.lexically_normal();
  entries_ = std::move(entries);
  typed_ = folder_.string();
  if (!typed_.ends_with("/")) typed_ += "/";
  selected_ = -1;
  problem_.clear();
}

void OpenDialog::accept(const fs::path& named) {
  const fs::path path = (folder_ / named).lexically_normal();  // `named` itself, if it is absolute
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) {
    enter(path);
  } else if (fs::exists(path, ignored)) {
    chosen_ = path.string();
  } else {
    problem_ = "There is no file " + path.string();
  }
}

void OpenDialog::draw(const RecentFiles& recent,
                      const std::function<void(const std::string&)>& chosen) {
  if (!open_) return;
  if (!ImGui::IsPopupOpen(kTitle)) ImGui::OpenPopup(kTitle);
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({screen.x / 2, screen.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSize(
      {std::min(scaled(880), screen.x * 0.94f), std::min(scaled(560), screen.y * 0.9f)});
  if (!ImGui::BeginPopupModal(kTitle, &open_,
                              ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove)) {
    open_ = false;
    return;
  }
  const float footer = 2 * ImGui::GetFrameHeightWithSpacing() + scaled(6);
  ImGui::BeginChild("places", {scaled(230), -footer});
  draw_places(recent);
  ImGui::EndChild();
  ImGui::SameLine(0, scaled(14));
  ImGui::PushStyleColor(ImGuiCol_ChildBg, palette::kPanel);
  ImGui::BeginChild("entries", {0, -footer}, false, ImGuiWindowFlags_AlwaysUseWindowPadding);
  draw_entries();
  ImGui::EndChild();
  ImGui::PopStyleColor();
  draw_path_field();

  if (pressed(ImGuiKey_Escape)) open_ = false;
  if (!chosen_.empty()) open_ = false;
  if (!open_) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
  if (!chosen_.empty()) chosen(std::exchange(chosen_, {}));
}

void OpenDialog::draw_places(const RecentFiles& recent) {
  dim_text("Places");
  const char* home = std::getenv("HOME");
  if (home && ImGui::Selectable("Home")) enter(home);
  std::error_code failure;
  const fs::path current = fs::current_path(failure);
  if (!failure && ImGui::Selectable("Current folder")) enter(current);
  if (recent.paths().empty()) return;
  ImGui::Dummy({0, scaled(6)});
  dim_text("Recent");
  for (const std::string& path : recent.paths()) {
    const fs::path file(path);
    const std::string label = shortened((file.parent_path().filename() / file.filename()).string(),
                                        ImGui::GetContentRegionAvail().x);
    if (ImGui::Selectable((label + "##" + path).c_str())) accept(file);
    tooltip(path);
  }
}

void OpenDialog::draw_entries() {
  if (folder_.has_parent_path() && folder_ != folder_.root_path()) {
    if (ImGui::Selectable("../", false, ImGuiSelectableFlags_DontClosePopups)) {
      std::error_code ignored;
      enter(fs::absolute(folder_ / "..", ignored).lexically_normal());
      return;
    }
  }
  for (int i = 0; i < static_cast<int>(entries_.size()); ++i) {
    const Entry& entry = entries_[i];
    const std::string label = entry.is_folder ? entry.name + "/" : entry.name;
    ImGui::PushStyleColor(ImGuiCol_Text, entry.is_folder ? palette::kDim : palette::kText);
    const bool clicked = ImGui::Selectable(
        label.c_str(), i == selected_,
        ImGuiSelectableFlags_AllowDoubleClick | ImGuiSelectableFlags_DontClosePopups);
    ImGui::PopStyleColor();
    if (i == selected_ && std::exchange(scroll_to_selection_, false)) ImGui::SetScrollHereY();
    if (!clicked) continue;
    selected_ = i;
    const fs::path path = folder_ / entry.name;
    if (entry.is_folder || ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
      accept(path);
      return;
    }
    typed_ = path.string();
  }
  if (entries_.empty()) dim_text("No scenes in this folder");
}

void OpenDialog::draw_path_field() {
  const float button = scaled(96);
  ImGui::SetNextItemWidth(-2 * (button + ImGui::GetStyle().ItemSpacing.x));
  if (std::exchange(focus_path_, false)) ImGui::SetKeyboardFocusHere();
  const bool entered = ImGui::InputText(
      "##path", &typed_, ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_CallbackHistory,
      &OpenDialog::choose_with_arrow, this);
  ImGui::SameLine();
  const bool open_pressed = ImGui::Button("Open", {button, 0});
  ImGui::SameLine();
  if (ImGui::Button("Cancel", {button, 0})) open_ = false;
  if (entered || open_pressed) {
    accept(typed_);
    focus_path_ = true;
  }
  if (problem_.empty()) {
    dim_text("Mitsuba XML or glTF 2.0. Arrow keys choose, Enter opens.");
  } else {
    ImGui::PushStyleColor(ImGuiCol_Text, palette::kError);
    ImGui::TextUnformatted(shortened(problem_, ImGui::GetContentRegionAvail().x).c_str());
    ImGui::PopStyleColor();
  }
}

/// ImGui calls this for the arrow keys; a text field that is being edited takes new text only here.
int OpenDialog::choose_with_arrow(ImGuiInputTextCallbackData* data) {
  OpenDialog& dialog = *static_cast<OpenDialog*>(data->UserData);
  dialog.move_selection(data->EventKey == ImGuiKey_UpArrow ? -1 : 1);
  if (dialog.selected_ < 0) return 0;
  const fs::path chosen = dialog.folder_ / dialog.entries_[dialog.selected_].name;
  data->DeleteChars(0, data->BufTextLen);
  data->InsertChars(0, chosen.c_str());
  return 0;
}

void OpenDialog::move_selection(int step) {
  if (entries_.empty()) return;
  selected_ = std::clamp(selected_ + step, 0, static_cast<int>(entries_.size()) - 1);
  scroll_to_selection_ = true;
}

}  // namespace guidelight

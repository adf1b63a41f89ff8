#include "ui/panels/file_dialog.h"

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

constexpr const char* kCheckpointExtension = ".checkpoint";

bool pressed(ImGuiKey key) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key)); }

std::string lower_case(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

bool looks_like_scene(const fs::path& path) {
  const std::string extension = lower_case(path.extension().string());
  return extension == ".xml" || extension == ".gltf" || extension == ".glb";
}

bool looks_like_checkpoint(const fs::path& path) {
  return lower_case(path.extension().string()) == kCheckpointExtension;
}

bool looks_like_linear_picture(const fs::path& path) {
  const std::string extension = lower_case(path.extension().string());
  return extension == ".exr" || extension == ".hdr" || extension == ".png";
}

}  // namespace

FileRequest open_scene_request() {
  return {.title = "Open scene",
          .verb = "Open",
          .hint = "Mitsuba XML or glTF 2.0. Arrow keys choose, Enter opens.",
          .none = "No scenes in this folder",
          .shows = looks_like_scene};
}

FileRequest load_reference_request() {
  return {.title = "Load reference",
          .verb = "Load",
          .hint = "A picture of the same size and view. Arrow keys choose, Enter loads.",
          .none = "No pictures in this folder",
          .shows = looks_like_linear_picture};
}

FileRequest save_checkpoint_request() {
  return {.title = "Save checkpoint",
          .verb = "Save",
          .hint = "The progress of the render, to go on with it later. Enter saves.",
          .none = "No checkpoints in this folder",
          .shows = looks_like_checkpoint,
          .new_extension = kCheckpointExtension};
}

FileRequest resume_checkpoint_request() {
  return {.title = "Resume checkpoint",
          .verb = "Resume",
          .hint = "Opens the scene if need be. Arrow keys choose, Enter resumes.",
          .none = "No checkpoints in this folder",
          .shows = looks_like_checkpoint};
}

void FileDialog::open(FileRequest request, const std::string& start) {
  request_ = std::move(request);
  open_ = true;
  focus_path_ = true;
  chosen_.clear();
  to_replace_.clear();
  std::error_code ignored;
  const fs::path path = start.empty() ? fs::current_path(ignored) : fs::path(start);
  enter(writes() ? path.parent_path() : path);
  if (writes()) typed_ = path.string();
}

void FileDialog::enter(const fs::path& folder) {
  std::error_code failure;
  std::vector<Entry> entries;
  for (auto entry = fs::directory_iterator(folder, failure); !failure && entry != fs::end(entry);
       entry.increment(failure)) {
    std::error_code ignored;
    const std::string name = entry->path().filename().string();
    const bool is_folder = entry->is_directory(ignored);
    if (name.starts_with(".") || (!is_folder && !request_.shows(name))) continue;
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

void FileDialog::accept(const fs::path& named) {
  const fs::path path = (folder_ / named).lexically_normal();  // `named` itself, if it is absolute
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) {
    enter(path);
  } else if (writes()) {
    accept_for_writing(path);
  } else if (fs::exists(path, ignored)) {
    chosen_ = path.string();
  } else {
    problem_ = "There is no file " + path.string();
  }
}

void FileDialog::accept_for_writing(fs::path path) {
  if (!path.has_extension()) path += request_.new_extension;
  std::error_code ignored;
  if (!fs::is_directory(path.parent_path(), ignored)) {
    problem_ = "There is no folder " + path.parent_path().string();
  } else if (fs::exists(path, ignored) && to_replace_ != path) {
    to_replace_ = path.string();
    problem_ = "There is a file of this name: once more to replace it";
  } else {
    chosen_ = path.string();
  }
}

void FileDialog::draw(const RecentFiles& recent) {
  if (!open_) return;
  if (!ImGui::IsPopupOpen(request_.title)) ImGui::OpenPopup(request_.title);
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({screen.x / 2, screen.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSize(
      {std::min(scaled(880), screen.x * 0.94f), std::min(scaled(560), screen.y * 0.9f)});
  if (!ImGui::BeginPopupModal(request_.title, &open_,
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
  if (!chosen_.empty()) request_.chosen(std::exchange(chosen_, {}));
}

void FileDialog::draw_places(const RecentFiles& recent) {
  dim_text("Places");
  const char* home = std::getenv("HOME");
  if (home && ImGui::Selectable("Home")) enter(home);
  std::error_code failure;
  const fs::path current = fs::current_path(failure);
  if (!failure && ImGui::Selectable("Current folder")) enter(current);
  if (!recent.paths().empty() && request_.shows(recent.paths().front())) draw_recent(recent);
}

void FileDialog::draw_recent(const RecentFiles& recent) {
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

void FileDialog::draw_entries() {
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
  if (entries_.empty()) dim_text(request_.none);
}

void FileDialog::draw_path_field() {
  const float button = scaled(96);
  ImGui::SetNextItemWidth(-2 * (button + ImGui::GetStyle().ItemSpacing.x));
  if (std::exchange(focus_path_, false)) ImGui::SetKeyboardFocusHere();
  const bool entered =
      ImGui::InputText("##path", &typed_,
                       ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll |
                           ImGuiInputTextFlags_CallbackHistory,
                       &FileDialog::choose_with_arrow, this);
  ImGui::SameLine();
  const bool pressed_button = ImGui::Button(request_.verb, {button, 0});
  ImGui::SameLine();
  if (ImGui::Button("Cancel", {button, 0})) open_ = false;
  if (entered || pressed_button) {
    accept(typed_);
    focus_path_ = true;
  }
  if (problem_.empty()) {
    dim_text(request_.hint);
  } else {
    ImGui::PushStyleColor(ImGuiCol_Text, palette::kError);
    ImGui::TextUnformatted(shortened(problem_, ImGui::GetContentRegionAvail().x).c_str());
    ImGui::PopStyleColor();
  }
}

/// ImGui calls this for the arrow keys; a text field that is being edited takes new text only here.
int FileDialog::choose_with_arrow(ImGuiInputTextCallbackData* data) {
  FileDialog& dialog = *static_cast<FileDialog*>(data->UserData);
  dialog.move_selection(data->EventKey == ImGuiKey_UpArrow ? -1 : 1);
  if (dialog.selected_ < 0) return 0;
  const fs::path chosen = dialog.folder_ / dialog.entries_[dialog.selected_].name;
  data->DeleteChars(0, data->BufTextLen);
  data->InsertChars(0, chosen.c_str());
  return 0;
}

void FileDialog::move_selection(int step) {
  if (entries_.empty()) return;
  selected_ = std::clamp(selected_ + step, 0, static_cast<int>(entries_.size()) - 1);
  scroll_to_selection_ = true;
}

}  // namespace guidelight

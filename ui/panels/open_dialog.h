#pragma once

#include <imgui.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "ui/recent_files.h"

namespace guidelight {

/// The viewer's own dialog to choose a scene file: places, folders, scene files and a path to type.
class OpenDialog {
 public:
  /// Opens on a folder; an empty one is the current.
  void open(const std::string& folder);
  bool is_open() const { return open_; }
  /// Calls `chosen` with the path of a scene file once, when the dialog is left with one.
  void draw(const RecentFiles& recent, const std::function<void(const std::string&)>& chosen);

 private:
  struct Entry {
    std::string name;
    bool is_folder;
  };

  void enter(const std::filesystem::path& folder);
  void draw_places(const RecentFiles& recent);
  void draw_entries();
  void draw_path_field();
  static int choose_with_arrow(ImGuiInputTextCallbackData* data);
  void move_selection(int step);
  /// Enters the folder or takes the file; relative names are those of the folder shown.
  void accept(const std::filesystem::path& named);

  bool open_ = false;
  bool focus_path_ = false;
  bool scroll_to_selection_ = false;
  std::filesystem::path folder_;
  std::vector<Entry> entries_;
  int selected_ = -1;
  std::string typed_;
  std::string problem_;
  std::string chosen_;
};

/// Whether a file's name is that of a scene: .xml, .gltf or .glb.
bool looks_like_scene(const std::filesystem::path& path);

}  // namespace guidelight

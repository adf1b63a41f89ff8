#pragma once

#include <imgui.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "ui/recent_files.h"

namespace guidelight {

/// What a file is wanted for.
struct FileRequest {
  const char* title;
  const char* verb;                             // on the button, "Open"
  const char* hint;                             // which files are meant
  const char* none;                             // shown for a folder without any
  bool (*shows)(const std::filesystem::path&);  // which files are listed
  const char* new_extension = nullptr;          // with dot, of files to write; null to read
  std::function<void(const std::string& path)> chosen = {};  // called once, if a file is chosen
};

/// The viewer's own dialog to choose a file: places, folders, files and a path to type.
class FileDialog {
 public:
  /// Opens on a folder, or on a file that is suggested for writing; empty is the current folder.
  void open(FileRequest request, const std::string& start);
  bool is_open() const { return open_; }
  /// `recent` files are among the places if the request lists such files.
  void draw(const RecentFiles& recent);

 private:
  struct Entry {
    std::string name;
    bool is_folder;
  };

  bool writes() const { return request_.new_extension != nullptr; }
  void enter(const std::filesystem::path& folder);
  void draw_places(const RecentFiles& recent);
  void draw_recent(const RecentFiles& recent);
  void draw_entries();
  void draw_path_field();
  static int choose_with_arrow(ImGuiInputTextCallbackData* data);
  void move_selection(int step);
  /// Enters the folder or takes the file; relative names are those of the folder shown.
  void accept(const std::filesystem::path& named);
  /// A file that exists is replaced only if it is accepted twice.
  void accept_for_writing(std::filesystem::path path);

  FileRequest request_{};
  bool open_ = false;
  bool focus_path_ = false;
  bool scroll_to_selection_ = false;
  std::filesystem::path folder_;
  std::vector<Entry> entries_;
  int selected_ = -1;
  std::string typed_;
  std::string problem_;
  std::string to_replace_;
  std::string chosen_;
};

FileRequest open_scene_request();
FileRequest save_checkpoint_request();
FileRequest resume_checkpoint_request();
FileRequest load_reference_request();

}  // namespace guidelight

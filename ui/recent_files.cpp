#include "ui/recent_files.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "renderer/error.h"
#include "renderer/io/atomic_file.h"

namespace guidelight {

RecentFiles::RecentFiles(std::string list_path) : list_path_(std::move(list_path)) {
  std::ifstream file(list_path_);
  for (std::string line; paths_.size() < kMostKept && std::getline(file, line);) {
    if (!line.empty()) paths_.push_back(line);
  }
}

void RecentFiles::add(const std::string& path) {
  std::erase(paths_, path);
  paths_.insert(paths_.begin(), path);
  if (paths_.size() > kMostKept) paths_.resize(kMostKept);

  const auto folder = std::filesystem::path(list_path_).parent_path();
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  if (failure) {
    throw Error(
        "cannot create the folder {} for the list of recent files ({}): set XDG_STATE_HOME to a "
        "folder that can be written",
        folder.string(), failure.message());
  }
  std::string text;
  for (const std::string& line : paths_) text += line + "\n";
  write_file_atomically(list_path_, text);
}

std::string RecentFiles::default_path() {
  const char* state = std::getenv("XDG_STATE_HOME");
  if (state && *state) return std::string(state) + "/guidelight/recent";
  const char* home = std::getenv("HOME");
  return std::string(home ? home : ".") + "/.local/state/guidelight/recent";
}

}  // namespace guidelight

#pragma once

#include <string>
#include <vector>

namespace guidelight {

/// The scenes opened last, newest first, kept in a text file with one path per line.
class RecentFiles {
 public:
  static constexpr size_t kMostKept = 12;

  /// Reads the list; a file that is missing or unreadable is an empty list.
  explicit RecentFiles(std::string list_path = default_path());

  /// Puts a path first and saves the list. Throws Error if it cannot be written.
  void add(const std::string& path);
  const std::vector<std::string>& paths() const { return paths_; }

  /// $XDG_STATE_HOME/guidelight/recent, or ~/.local/state/guidelight/recent.
  static std::string default_path();

 private:
  std::string list_path_;
  std::vector<std::string> paths_;
};

}  // namespace guidelight

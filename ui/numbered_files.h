#pragma once

#include <set>
#include <string>

namespace guidelight {

/// Names for files in a folder that overwrite no others: "box.png", "box-2.png" …
class NumberedFiles {
 public:
  explicit NumberedFiles(std::string folder) : folder_(std::move(folder)) {}

  /// The first path that is neither on disk nor was given out before.
  std::string next(const std::string& stem, const std::string& extension);
  /// The same without giving it out.
  std::string suggest(const std::string& stem, const std::string& extension) const;

 private:
  std::string folder_;
  std::set<std::string> claimed_;  // may not be on disk yet
};

}  // namespace guidelight

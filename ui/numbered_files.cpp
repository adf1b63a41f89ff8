#include "ui/numbered_files.h"

#include <fmt/format.h>

#include <filesystem>

namespace guidelight {

std::string NumberedFiles::next(const std::string& stem, const std::string& extension) {
  return *claimed_.insert(suggest(stem, extension)).first;
}

std::string NumberedFiles::suggest(const std::string& stem, const std::string& extension) const {
  namespace fs = std::filesystem;
  std::error_code ignored;  // a folder that cannot be read is reported when it is written to
  for (int number = 1;; ++number) {
    const std::string name = number == 1 ? stem : fmt::format("{}-{}", stem, number);
    const std::string path = (fs::path(folder_) / (name + "." + extension)).string();
    if (!fs::exists(path, ignored) && !claimed_.contains(path)) return path;
  }
}

}  // namespace guidelight

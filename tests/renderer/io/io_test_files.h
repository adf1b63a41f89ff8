#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "renderer/io/scene_file.h"

namespace guidelight::test {

/// A folder that disappears with the object.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "guidelight-XXXXXX").string();
    path_ = ::mkdtemp(name.data());
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::string operator/(const std::string& name) const { return (path_ / name).string(); }
  const std::filesystem::path& path() const { return path_; }

  /// Writes a file and returns its path.
  std::string write(const std::string& name, const std::string& bytes) const {
    const std::filesystem::path path = path_ / name;
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary) << bytes;
    return path.string();
  }

 private:
  std::filesystem::path path_;
};

inline std::string file_bytes(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// What a Mitsuba scene with this content says.
inline SceneDescription read_mitsuba(const TemporaryFolder& folder, const std::string& body,
                                     const std::string& version = "3.0.0",
                                     const std::map<std::string, std::string>& defines = {}) {
  const std::string path =
      folder.write("scene.xml", "<scene version=\"" + version + "\">\n" + body + "\n</scene>\n");
  return read_scene(path, defines);
}

inline SceneDescription read_mitsuba(const std::string& body,
                                     const std::string& version = "3.0.0") {
  const TemporaryFolder folder;
  return read_mitsuba(folder, body, version);
}

/// The message of the Error that reading throws; empty if it does not throw.
inline std::string mitsuba_error(const std::string& body) {
  try {
    read_mitsuba(body);
    return "";
  } catch (const std::exception& error) {
    return error.what();
  }
}

}  // namespace guidelight::test

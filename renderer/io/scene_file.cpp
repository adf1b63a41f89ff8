#include "renderer/io/scene_file.h"

#include <filesystem>

#include "renderer/error.h"
#include "renderer/io/gltf/reader.h"
#include "renderer/io/mitsuba/reader.h"
#include "renderer/io/read_file.h"

namespace guidelight {
namespace {

enum class SceneFormat { Mitsuba, Gltf, Unknown };

SceneFormat detect(const std::string& bytes) {
  if (bytes.starts_with("glTF")) return SceneFormat::Gltf;
  const size_t start = bytes.starts_with("\xef\xbb\xbf") ? 3 : 0;  // byte order mark
  const size_t first = bytes.find_first_not_of(" \t\r\n", start);
  if (first == std::string::npos) return SceneFormat::Unknown;
  if (bytes[first] == '<') return SceneFormat::Mitsuba;
  return bytes[first] == '{' ? SceneFormat::Gltf : SceneFormat::Unknown;
}

}  // namespace

SceneDescription read_scene(const std::string& path,
                            const std::map<std::string, std::string>& defines) {
  const std::string bytes = read_file_bytes(path);
  SceneDescription scene;
  switch (detect(bytes)) {
    case SceneFormat::Mitsuba:
      scene = mitsuba::read_mitsuba_scene(path, defines);
      break;
    case SceneFormat::Gltf:
      scene = gltf::read_gltf_scene(path, bytes);
      break;
    case SceneFormat::Unknown:
      throw Error(
          "Cannot open '{}': it is neither a Mitsuba XML nor a glTF scene; choose an .xml, "
          ".gltf or .glb file.",
          path);
  }
  scene.path = path;
  if (scene.name.empty()) scene.name = std::filesystem::path(path).stem().string();
  return scene;
}

}  // namespace guidelight

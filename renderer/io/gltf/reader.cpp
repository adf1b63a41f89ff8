#include "renderer/io/gltf/reader.h"

#include "renderer/error.h"
namespace guidelight::gltf {
SceneDescription read_gltf_scene(const std::string& path, const std::string&) {
  throw Error("Cannot open '{}': glTF scenes are not read yet; use a Mitsuba XML scene.", path);
}
}  // namespace guidelight::gltf

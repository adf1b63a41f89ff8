#pragma once

#include <string>

#include "renderer/scene/description.h"

namespace guidelight::gltf {

/// Reads a glTF 2.0 scene, text or binary, whose bytes are already in memory; files it names are
/// looked for beside `path`. Throws Error with file, reason and remedy.
SceneDescription read_gltf_scene(const std::string& path, const std::string& bytes);

}  // namespace guidelight::gltf

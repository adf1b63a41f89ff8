#pragma once

#include <map>
#include <string>

#include "renderer/scene/description.h"

namespace guidelight {

/// Reads a scene: Mitsuba XML (.xml, versions 0.5 to 3) or glTF 2.0 (.gltf, .glb), told apart by
/// content. `defines` override <default> variables of an XML scene. Unsupported parts become
/// warnings in the result; a file that cannot be opened as a scene throws Error with file, line,
/// reason and remedy.
SceneDescription read_scene(const std::string& path,
                            const std::map<std::string, std::string>& defines = {});

}  // namespace guidelight

#pragma once

#include <map>
#include <memory>
#include <string>

#include "renderer/scene/description.h"

namespace guidelight {

/// Reads a scene file for rendering: as read_scene, with a warning added if the file asks for an
/// integrator for which the path tracer stands in, its path made absolute, and its
/// hash taken.
/// Throws Error as read_scene does.
std::shared_ptr<SceneDescription> open_scene(
    const std::string& path, const std::map<std::string, std::string>& defines = {});

}  // namespace guidelight

#pragma once

#include <map>
#include <string>

#include "renderer/scene/description.h"

namespace guidelight::mitsuba {

/// Reads a Mitsuba XML scene. Throws Error with file, line, reason and remedy.
SceneDescription read_mitsuba_scene(const std::string& path,
                                    const std::map<std::string, std::string>& defines);

}  // namespace guidelight::mitsuba

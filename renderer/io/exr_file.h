#pragma once

#include <string>
#include <string_view>

#include "renderer/io/image_file.h"

/// OpenEXR lives here. Everybody else uses image_file.h.
namespace guidelight {

bool is_exr(std::string_view bytes);

/// All layers of an EXR in memory; `name` stands for the file in messages.
ImageLayers decode_exr(std::string_view bytes, const std::string& name);

/// Its string attributes alone.
Metadata decode_exr_metadata(std::string_view bytes, const std::string& name);

}  // namespace guidelight

#pragma once

#include <string>
#include <string_view>

#include "renderer/io/image_file.h"

/// Text chunks of PNG (ISO/IEC 15948, 11.3.4). Keys have 1 to 79 bytes.
namespace guidelight {

bool is_png(std::string_view bytes);

/// The PNG with text chunks after its header: tEXt for ASCII, iTXt (UTF-8, not compressed) for the
/// rest.
std::string insert_png_metadata(const std::string& png, const Metadata& metadata);

/// All tEXt and uncompressed iTXt chunks. A damaged chunk ends the reading.
Metadata png_metadata(std::string_view png);

}  // namespace guidelight

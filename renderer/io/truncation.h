#pragma once

#include <string_view>

namespace guidelight {

/// stb fills what is missing of an image with zeros; this notices first. Knows PNG, JPEG, Radiance
/// HDR, BMP and TGA, and refuses every other format. Throws Error with the reason
/// only.
void check_not_truncated(std::string_view bytes);

}  // namespace guidelight

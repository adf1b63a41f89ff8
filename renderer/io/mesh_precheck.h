#pragma once

#include <string_view>

namespace guidelight {

/// Refuse files that claim more than they hold before the mesh library allocates for it. Throw
/// Error with the reason only.
void check_ply(std::string_view bytes);
void check_obj(std::string_view bytes);

}  // namespace guidelight

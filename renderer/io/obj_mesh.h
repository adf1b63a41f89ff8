#pragma once

#include <string_view>

#include "renderer/scene/description.h"

namespace guidelight {

/// A Wavefront OBJ file in memory: v (with colours where there are any), vt, vn and f of all groups
/// as one mesh; corners that name the same indices share a vertex, polygons become fans. Normals
/// count only if every corner has one. Materials are the scene's business. Throws Error with the
/// reason only.
///
/// Written here because Debian's assimp is built with assertions that abort the program on bad
/// input.
Mesh decode_obj(std::string_view bytes);

}  // namespace guidelight

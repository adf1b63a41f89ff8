#pragma once

#include <string_view>

#include "renderer/scene/description.h"

namespace guidelight {

/// A PLY file in memory (Turk 1994, "The PLY Polygon File Format"): text or binary of either byte
/// order. Reads x y z, nx ny nz, u v (or s t, texture_u texture_v), red green blue (or r g b) of
/// `vertex` and the index lists of `face`, and skips everything else. Throws Error with the reason
/// only.
///
/// Written here because Debian's assimp misreads binary vertices and aborts on some polygons.
Mesh decode_ply(std::string_view bytes);

}  // namespace guidelight

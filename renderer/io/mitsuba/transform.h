#pragma once

#include "renderer/io/mitsuba/document.h"
#include "renderer/math/vector.h"

namespace guidelight::mitsuba {

/// The matrix of a <transform>: its parts apply in the order they are written. Throws Error for
/// numbers that cannot be read or are not finite.
Mat4 parse_transform(const Node& node);

/// The same for texture coordinates: acts on (u, v, 1).
Mat3 parse_uv_transform(const Node& node);

/// x, y, z attributes, or `value` with one or three numbers; each part missing is `fallback`.
Vec3 parse_vector(const Node& node, Vec3 fallback);

/// Camera-to-world: +z towards the target, +y near `up`, +x to the left. Throws Error with the
/// reason only if origin and target coincide.
Mat4 look_at(Vec3 origin, Vec3 target, Vec3 up);

}  // namespace guidelight::mitsuba

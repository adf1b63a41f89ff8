#pragma once

#include "renderer/scene/description.h"

namespace guidelight {

/// Half the width and height at unit distance of a picture that is `aspect` times as wide as high
/// and spans `fov` [degrees] along an axis.
Vec2 half_extent(float fov, FovAxis axis, float aspect);

}  // namespace guidelight

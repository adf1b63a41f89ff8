#pragma once

#include "renderer/scene/description.h"

namespace guidelight {

/// Whether a shape can be drawn with its transform. One that is flat and scaled to nothing along
/// its normal only gets a thickness of its own, so that the transform can be inverted; any other
/// with a singular transform has no surface. Transforms that are not finite are left for the scene
/// to refuse.
bool keep_drawable(ShapeDescription& shape);

}  // namespace guidelight

#pragma once

#include "renderer/scene/description.h"

namespace guidelight {

/// A perspective camera that looks at all shapes of a scene along -z, a little from above (+y is
/// up).
CameraDescription framing_camera(const SceneDescription& scene);

}  // namespace guidelight

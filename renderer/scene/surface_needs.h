#pragma once

#include "renderer/scene/description.h"

namespace guidelight {

/// What a material looks at beyond position and normal. Most look at nothing.
struct SurfaceNeeds {
  bool parametrisation = false;   // texture coordinates, tangents or vertex colours
  bool perturbed_normal = false;  // a normal or bump map

  SurfaceNeeds& operator|=(const SurfaceNeeds& other);
};

/// Of a BSDF with everything nested in it; kNone needs nothing.
SurfaceNeeds needs_of_bsdf(const SceneDescription& scene, int bsdf);

}  // namespace guidelight

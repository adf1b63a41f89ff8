#pragma once

#include <memory>

#include "renderer/metropolis/mutation.h"

namespace guidelight {

/// Rebuilds the end of a path from the light: turns the direction at the last finite vertex before
/// the one that the eye sees a little, follows the specular events between and joins the new vertex
/// with the lens: (D|L) S* D E (Veach 1997, 11.3.2). Where the direction is that of a light at
/// infinity, the ray is shifted instead.
std::unique_ptr<Mutation> make_caustic_perturbation(const Scene& scene);

}  // namespace guidelight

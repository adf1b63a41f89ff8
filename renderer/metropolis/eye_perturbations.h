#pragma once

#include <memory>

#include "renderer/metropolis/mutation.h"

namespace guidelight {

// Perturbations that rebuild a path from the eye, scattering as it did (Veach 1997, 11.3.2–3;
// Fan et al. 2005, section 4.3). Each ends where the path can be joined with what is kept, or on
// the light.

/// Moves the place in the picture a little and follows specular events to the first finite one:
/// (L|D) D S* E and L S* E.
std::unique_ptr<Mutation> make_lens_perturbation(const Scene& scene);

/// The same for paths on which specular vertices follow the first finite one, whose direction is
/// turned a little as well: (L|D) (D S+)+ D? S* E.
std::unique_ptr<Mutation> make_multi_chain_perturbation(const Scene& scene);

/// Keeps the path from the eye to its first finite vertex and turns the direction from there by an
/// angle uniform up to `max_angle` [rad]: for photons, which all must not cluster where the eye
/// looks.
std::unique_ptr<Mutation> make_photon_map_perturbation(const Scene& scene, float max_angle);

}  // namespace guidelight

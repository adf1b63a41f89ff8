#pragma once

#include "renderer/photons/hash_grid.h"
#include "renderer/photons/photon.h"
#include "renderer/scene/bsdf/scattering.h"

namespace guidelight {

/// What one pass found around the points that share a density estimate.
struct FoundLight {
  int count = 0;         // M: photons whose light reaches the camera
  Color direct{0.0f};    // τ_M, of paths of at most two segments …
  Color indirect{0.0f};  // … and of longer ones
  Color caustic{0.0f};   // the part of `indirect` that FilmSample::caustic describes
  float excess = 0;  // luminance of τ_M that is there because the radius is not 0; see gather()
};

/// Where and how light is gathered.
struct GatherPoint {
  Vec3 position;
  Color throughput;  // of the camera path up to here, times its weight
  int length;        // of the same [segments]
  float radius;
};

/// Photons of one pass, and which paths are wanted.
struct MeasuredPhotons {
  HashGrid<Photon> photons;
  int min_length;  // segments of the full path
  int max_length;
};

/// Adds the flux of the photons around a point. `surface()` is asked for the Scattering there, once
/// photons have been found.
///
/// The excess estimates the bias from the photons' distances d. Where the density of the flux is
/// L + ¼ΔL·d² in the mean over directions, u = d²/R² is uniform in [0,1] up to the second term, so
/// that the estimate of L is too large by ΔL·R²/8, and Σ(2u - 1)φ/(πR²) has the mean ΔL·R²/24: a
/// third of it. Along a sharp edge it is 0.18 of the bias (root mean squares over the distances
/// from the edge). The factor 4 is between 3 and 5.5, wrong by a third at either end.
template <class SurfaceAt>
void gather(const MeasuredPhotons& map, const GatherPoint& point, SurfaceAt&& surface,
            FoundLight& found) {
  const float inverse_squared = 1 / sqr(point.radius);
  map.photons.for_each_within(
      point.position, point.radius, [&](const Photon& photon, float distance_squared) {
        const int length = photon.length() + point.length;
        if (length < map.min_length || length > map.max_length) return;
        const Scattering& scattering = surface();
        const Vec3 wi = photon.direction();
        const Color value = scattering.value(wi);
        if (is_black(value)) return;
        // Photons bring the cosine with them: see shaded_power().
        const Color bsdf = value / scattering.shading_cosine(wi);
        const Color flux = point.throughput * bsdf * photon.power();
        ++found.count;
        (length <= 2 ? found.direct : found.indirect) += flux;
        if (photon.caustic()) found.caustic += flux;
        found.excess += 4 * (2 * distance_squared * inverse_squared - 1) * luminance(flux);
      });
}

}  // namespace guidelight

#pragma once

#include <algorithm>

#include "renderer/photons/packing.h"
#include "renderer/sampling/hash_position.h"
#include "renderer/scene/bsdf/scattering.h"
#include "renderer/transport/mis_partials.h"
#include "renderer/transport/path_vertex.h"

namespace guidelight {

/// A vertex of a light path, for density estimation. What one wants to know beside the position is
/// packed, because maps of millions of photons are limited by memory traffic.
struct Photon {
  Vec3 position{0};
  uint32_t packed_direction = 0;  // bits 0-23 direction, 24-30 length, 31 caustic
  uint32_t packed_power = 0;
  MisPartials partials;

  /// Unit, towards where the photon came from.
  Vec3 direction() const { return unpack_direction(packed_direction); }
  /// Flux, in the unit of the maker (watts, or watts times the number of light paths). The maker
  /// says whether it is what meets the true surface or the shading one (see shaded_power).
  Color power() const { return unpack_color(packed_power); }
  /// Segments of the light path that ends here, 127 for any more.
  int length() const { return static_cast<int>(packed_direction >> 24 & 0x7f); }
  /// The path was specular at all vertices before this one, of which there is at least one.
  bool caustic() const { return packed_direction >> 31; }
};
static_assert(sizeof(Photon) == 32);

/// Packs a photon. Its power is right in the mean over photons (see pack_color); the same photon is
/// always packed alike.
inline Photon make_photon(Vec3 position, Vec3 wi, Color power, int length, bool caustic,
                          const MisPartials& partials = {}) {
  const uint64_t dither = hash_position(position);
  const auto clamped_length = static_cast<uint32_t>(std::clamp(length, 0, 127));
  return {position,
          pack_direction(wi) | clamped_length << 24 | static_cast<uint32_t>(caustic) << 31,
          pack_color(power, dither), partials};
}

/// The flux that a light vertex brings to the surface as its shading normal sees it:
/// Φ·|ω·ns|/|ω·ng|. An estimate of the radiance that leaves a point x is then Σ
/// Φ·|ω·ns|/|ω·ng|·f(x,ω), with no cosine at x. For as the photons' density of flux over the true
/// surface is L|ω·ng|, both cosines being the photon's own, the sum has the mean ∫ L f |ω·ns| dω
/// around x. To take both at x instead is the same in the limit of a small radius, but before that
/// a photon may come from another facet, where |ω·ng| is large, and be divided by one near 0. 0
/// where the direction leaks.
inline Color shaded_power(const PathVertex& vertex, const Scattering& scattering) {
  return vertex.throughput * scattering.shading_gain();
}

}  // namespace guidelight

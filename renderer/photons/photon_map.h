#pragma once

#include "renderer/photons/density_estimate.h"
#include "renderer/photons/kd_tree.h"
#include "renderer/photons/photon.h"
#include "renderer/photons/sharp_scattering.h"

namespace guidelight {

/// A photon that knows its surface.
struct SurfacePhoton : Photon {
  uint32_t packed_normal = 0;

  /// Unit geometric normal on the side that the photon came from.
  Vec3 normal() const { return unpack_direction(packed_normal); }
};

/// The photon of a light vertex. `power` in watts: divided by the number of light paths.
SurfacePhoton make_surface_photon(const PathVertex& vertex, Color power, bool caustic);

/// Whether a photon's place is one of those where irradiance is computed ahead; about every fourth.
bool is_irradiance_point(const SurfacePhoton& photon);

/// How photons are gathered into an estimate.
struct EstimateSettings {
  static constexpr int kMaxNeighbors = 1024;

  int neighbors = 60;      // k, at most kMaxNeighbors
  float max_distance = 0;  // [scene units]
  Kernel kernel = Kernel::Cone;
  int min_length = 1;  // of whole paths [segments]
  int max_length = 0;
  SharpScattering sharp{0};
  /// If above 1: k photons of the same surface are looked for among so many times k of any. Where
  /// there are fewer, the surface is too small for an estimate, and none is made.
  int oversearch = 1;
  /// Fewest photons that an estimate may rest on, by (Σx)²/Σx² of what they contribute; where there
  /// are fewer, none is made. Narrow lobes see few of the photons around.
  float min_effective = 0;
};

/// Photons in the order of a kd-tree, and radiance estimates from the k nearest (Jensen 1996,
/// "Global Illumination using Photon Maps").
class PhotonMap {
 public:
  PhotonMap() = default;
  PhotonMap(std::span<const SurfacePhoton> photons, Parallel& parallel)
      : tree_(photons, parallel) {}

  std::span<const SurfacePhoton> photons() const { return tree_.items(); }

  /// Radiance that leaves a camera vertex towards `wo` after diffuse scattering of the photons
  /// around it.
  Color radiance(const PathVertex& vertex, const Scattering& scattering,
                 const EstimateSettings& settings) const;

  struct Irradiance {
    Color value;
    float radius_squared;  // of the disc that it is an estimate of
  };
  /// Irradiance of a surface on the side of its unit normal, by photons of at most `max_length`
  /// segments that are not is_irradiance_point(); scaled up for those.
  Irradiance irradiance(Vec3 position, Vec3 normal, const EstimateSettings& settings,
                        int max_length) const;

 private:
  /// The k photons nearest to a point that lie on a surface of the same direction, or none.
  Neighbors nearest_on_surface(const SurfacePoint& point, const EstimateSettings& settings,
                               std::span<Neighbor> buffer) const;

  KdTree<SurfacePhoton> tree_;
};

/// Irradiance computed ahead at the places of a quarter of the photons, for surfaces that reflect
/// all light alike: an estimate then costs a search of one point (Christensen 1999, "Faster Photon
/// Map Global Illumination").
///
/// The quarter is chosen by chance and does not take part in the estimates. Two parts of a Poisson
/// process that is divided so are independent; otherwise the estimates would be too high, because
/// every one finds the photon it stands on, or without that too low, because the nearest place to
/// look at is more often one where photons are sparse.
class IrradianceMap {
 public:
  IrradianceMap() = default;
  /// Of light paths of at most `max_length` segments.
  IrradianceMap(const PhotonMap& photons, const EstimateSettings& settings, int max_length,
                Parallel& parallel);

  /// From the nearest point of the same surface and side; empty if there is none within
  /// `max_distance`. Points off the plane must have an estimate that reaches as far as here: what
  /// is behind a thin wall may be bright, with many photons in small discs.
  std::optional<Color> irradiance(Vec3 position, Vec3 normal, float max_distance) const;

 private:
  struct Point {
    Vec3 position;
    uint32_t packed_normal;
    Color irradiance;
    float reach_squared;
  };
  KdTree<Point> tree_;
};

/// The BSDF's value [1/sr] if it is the same for all pairs of directions on the side of wo, as of
/// Lambert's reflector; radiance is then this times the irradiance. Empty for any other.
std::optional<Color> lambertian_value(const PathVertex& vertex, const Scattering& scattering);

/// The vertex's shading normal on the side that the path came from.
inline Vec3 normal_towards_viewer(const PathVertex& vertex) {
  const Vec3 normal = vertex.point.frame.n;
  return glm::dot(normal, vertex.wo) < 0 ? -normal : normal;
}

}  // namespace guidelight

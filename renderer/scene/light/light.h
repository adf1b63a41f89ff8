#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "renderer/scene/description.h"
#include "renderer/scene/shape.h"
#include "renderer/scene/texture.h"

namespace guidelight {

/// Light chosen to illuminate a given point.
struct DirectSample {
  Vec3 wi;             // unit, from the reference towards the light
  float distance;      // infinity for lights at infinity
  Color radiance;      // Le towards the reference; for delta lights intensity/d² or irradiance
  float pdf;           // per solid angle at the reference; 1 (discrete) for delta lights
  SurfacePoint point;  // position, geometric normal, uv, offset; for area lights only
  Vec3 position;       // end of the shadow ray, if distance is finite

  /// Densities of the same light path started on the light, for bidirectional weights:
  float pdf_position;   // as EmissionSample
  float pdf_direction;  // as EmissionSample
  float cos_light;      // |cosθ| at the light; 1 where it has no surface
};

/// First ray of a light path.
struct EmissionSample {
  Ray ray;             // origin already moved off the surface
  SurfacePoint point;  // for area lights: the vertex on the light
  Color weight;        // Le·cosθ / (pdf_position·pdf_direction)
  /// Finite lights: per area on the light; discrete 1 for a position that is a point.
  /// Lights at infinity: per area of the disk that faces the scene.
  float pdf_position;
  /// Per solid angle; discrete 1 for a direction that is a delta.
  float pdf_direction;
  float cos_light;  // |cosθ| at the light; 1 where it has no surface
};

/// Position and direction densities of emission, measures as in EmissionSample.
struct EmissionPdf {
  float position;
  float direction;
};

/// A light source. All densities are conditional on this light having been chosen. Immutable.
class Light {
 public:
  virtual ~Light() = default;

  /// Position is a single point (point, spot, projector): cannot be hit by chance.
  virtual bool is_delta_position() const { return false; }
  /// Direction is a single one (directional): cannot be hit by chance.
  virtual bool is_delta_direction() const { return false; }
  bool is_delta() const { return is_delta_position() || is_delta_direction(); }
  virtual bool is_infinite() const { return false; }

  /// Area lights: Le at a point of the light in a unit world direction away from it.
  virtual Color radiance(const SurfacePoint& point, Vec3 w) const {
    (void)point, (void)w;
    return Color(0);
  }
  /// Lights at infinity: Le arriving from the unit direction `towards` (away from the scene).
  virtual Color radiance_from(Vec3 towards) const {
    (void)towards;
    return Color(0);
  }

  virtual std::optional<DirectSample> sample_direct(Vec3 reference, Vec2 u) const = 0;
  /// Density of sample_direct per solid angle at the reference for a point hit on the area light;
  /// zero for lights that are not areas.
  virtual float pdf_direct(Vec3 reference, const SurfacePoint& point) const {
    (void)reference, (void)point;
    return 0;
  }
  /// The same for a direction that escapes to this light at infinity; zero for delta lights.
  virtual float pdf_direct_from(Vec3 towards) const {
    (void)towards;
    return 0;
  }

  virtual std::optional<EmissionSample> sample_emission(Vec2 u_position,
                                                        Vec2 u_direction) const = 0;
  /// Densities of sample_emission: leaving `point` (ignored by lights without surface) in unit
  /// direction w. A density of a delta component is 0.
  virtual EmissionPdf pdf_emission(const SurfacePoint& point, Vec3 w) const = 0;

  /// Position in Scene::lights(); set by the scene that owns the light.
  uint32_t index = kInvalidIndex;

  /// Emitted power [W], luminance, approximate; steers the choice of lights.
  virtual float power() const = 0;
};

/// What lights need to know about the scene.
struct LightContext {
  Vec3 scene_center{0};
  float scene_radius = 1;
  const TextureList* textures = nullptr;
};

/// An area light over a shape; the shape must outlive it.
std::unique_ptr<Light> make_area_light(const ColorInput& radiance, const Shape& shape,
                                       const LightContext& context);

/// Any other light; a sun-sky makes two (sun and sky).
std::vector<std::unique_ptr<Light>> make_lights(const EmitterDescription& description,
                                                const LightContext& context);

}  // namespace guidelight

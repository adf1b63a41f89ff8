#pragma once

#include <optional>
#include <span>

#include "renderer/scene/scene.h"
#include "renderer/transport/guide_path.h"

namespace guidelight {

/// Which way a traced guide takes where a smooth surface both reflects and refracts.
enum class SpecularChoice { Refract, Reflect };

/// A ray followed over specular surfaces to the first that scatters by a finite lobe.
struct GuideSegment {
  std::vector<GuideVertex> vertices;  // specular ones, and the last one that scatters
  SurfacePoint end;                   // the last vertex
  Vec3 arrival{0};                    // unit, the direction of the ray that reached it
};

/// Empty if the ray escapes, meets more than 32 specular surfaces, or a surface that neither
/// scatters nor has a specular event.
std::optional<GuideSegment> trace_guide_segment(const Scene& scene, Ray ray, SpecularChoice choice);

/// A guide that starts at a point of a light and is traced in a unit direction. Where it meets a
/// scattering surface before its `bounces` segments are used up it goes on as from a mirror.
/// Segments count from one scattering vertex to the next. It may be shorter; empty if no light at
/// `start` shines that way, if it meets nothing, or for numbers that are not finite. `direction`
/// points away from the light; for lights at infinity `start` is any point on its way.
std::optional<GuidePath> trace_guide(const Scene& scene, Vec3 start, Vec3 direction, int bounces,
                                     SpecularChoice choice = SpecularChoice::Refract);

/// The same, each segment aimed from the last scattering vertex at one of `targets`; specular
/// surfaces on the way are followed and may lead elsewhere. Shorter where a segment meets nothing;
/// empty if the first target is where the guide starts.
std::optional<GuidePath> trace_guide_through(const Scene& scene, Vec3 start,
                                             std::span<const Vec3> targets,
                                             SpecularChoice choice = SpecularChoice::Refract);

/// The first direction of the chain of specular events that leads from `from` to the point `target`
/// of a scattering surface, near the unit direction `guess`, which must follow the same events. By
/// Newton's method on the two angles. Empty if there is none near.
std::optional<GuideSegment> solve_guide_segment(const Scene& scene, const SurfacePoint& from,
                                                Vec3 guess, Vec3 target, SpecularChoice choice);

}  // namespace guidelight

#pragma once

#include <optional>

#include "renderer/sampling/random.h"
#include "renderer/scene/medium.h"
#include "renderer/scene/scene.h"
#include "renderer/transport/mis.h"

namespace guidelight {

class GuidedWalk;

/// A path under construction from a light or from the camera: the segment that is to be traced
/// next and what is known about it.
struct Subpath {
  Rng rng{0, 0, 0};
  Ray ray;
  Vec3 origin{0};          // the vertex that the segment leaves; ray.origin is moved off it
  Color throughput{1.0f};  // of everything up to this segment's direction
  float pdf = 0;           // of the direction per solid angle, survival included; discrete
                           // probability after a delta lobe
  float pdf_backward = 0;  // of scattering back at the origin, where that was by a finite lobe; per
                           // solid angle, survival included
  float cos_origin = 1;    // between the direction and the geometric normal at the origin
  MisSums sums;            // at the origin
  float merge_share = 1;   // see PathVertex
  float merging_before_origin = 0;  // the part of sums.merging without the origin itself
  const Medium* medium = nullptr;
  int length = 0;              // segments before this one
  bool is_parallel = false;    // the segment is one of parallel rays: `pdf` is per area across it
  bool is_connectible = true;  // the origin could have been connected to the segment's end
  bool is_specular_chain = true;             // no vertex so far scattered by a finite lobe
  const Light* light = nullptr;              // of a light path on its first segment …
  const EmissionSample* emission = nullptr;  // … and how it was emitted
  GuidedWalk* guided = nullptr;              // of a light path that may follow guides
};

/// Begins a camera path at a raster position; `rng` must be the path's own. The lens is vertex 0.
inline Subpath start_camera_path(const Scene& scene, Vec2 raster, Rng rng) {
  Subpath path;
  path.rng = rng;
  const Camera& camera = scene.camera();
  const CameraSample sample = camera.sample_ray(raster, path.rng.next_vec2());
  path.ray = sample.ray;
  path.origin = sample.lens_position;
  path.throughput = sample.weight;
  path.pdf = sample.pdf_direction;
  path.is_parallel = camera.description().model == CameraModel::Orthographic;
  path.medium = scene.camera_medium();
  return path;
}

/// Begins a light path; empty where nothing is emitted. `emission` is filled and must live until
/// the first vertex, and so must `guided`, by which the path may follow a guide; `emission_count`
/// is TechniqueCounts::emission. Weights take the density of the first segment with guides and of
/// all others without (docs/guides.md).
std::optional<Subpath> start_light_path(const Scene& scene, Rng rng, float emission_count,
                                        EmissionSample& emission, GuidedWalk* guided = nullptr);

}  // namespace guidelight

#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "renderer/sampling/distribution.h"
#include "renderer/scene/scene.h"
#include "renderer/transport/guide_path.h"

namespace guidelight {

/// One vertex of a light path, seen by a guide: how the path goes on from there.
struct GuidedStep {
  Vec3 direction;                        // unit, leaving the vertex
  PathEvent event = PathEvent::Scatter;  // at the vertex
};

/// The beginning of a light path that follows a guide.
struct GuidedStart {
  const Light* light;
  /// Densities and weight of Light::sample_emission for the same ray, as if the light had drawn it.
  EmissionSample emission;
};

/// All usable guides of a scene as one way to draw light paths. Guide j proposes: a point of the
/// light in a disc around its first vertex; at each vertex whose event is Scatter a direction in a
/// cone around its segment; at each other vertex the same specular event. It says nothing of paths
/// beyond its last vertex. Densities: position per area on the light (lights at infinity:
/// per area across the ray; points: discrete 1), directions per solid angle (directional
/// lights: discrete 1), specular events 1. docs/guides.md derives how it is used. Immutable; refers
/// to the scene's lights.
class GuideMixture {
 public:
  /// Of the enabled guides without fault and with a positive weight. Null if there is none.
  static std::shared_ptr<const GuideMixture> build(std::shared_ptr<const Scene> scene,
                                                   std::span<const GuidePath> guides);

  size_t size() const { return guides_.size(); }
  /// Position of a guide in the list that build() was given.
  uint32_t index_in_list(uint32_t guide) const { return guides_[guide].index_in_list; }
  /// Probability with which choose() takes a guide; they sum to 1.
  float weight(uint32_t guide) const { return weights_.pmf(guide); }
  uint32_t choose(float u) const { return weights_.sample(u).index; }

  /// Segments of the prefix that a guide proposes: from the light to its last vertex.
  int length(uint32_t guide) const { return static_cast<int>(guides_[guide].steps.size()); }
  /// How the guide goes on from a vertex, 0 ≤ vertex < length.
  PathEvent event(uint32_t guide, int vertex) const { return guides_[guide].steps[vertex].event; }

  /// Point on the light and first direction. Empty where the disc overlaps the light's edge or the
  /// light does not shine that way: the candidate is rejected.
  std::optional<GuidedStart> start(uint32_t guide, Vec2 u_position, Vec2 u_direction) const;
  /// Density of start(): position times direction. `point` is the one on an area light;
  /// `ray_origin` any point on the first segment, which lights at infinity need.
  double pdf_start(uint32_t guide, const Light& light, const SurfacePoint& point, Vec3 ray_origin,
                   Vec3 direction) const;

  /// Direction that leaves a vertex with a Scatter event, 1 ≤ vertex < length.
  Vec3 sample_direction(uint32_t guide, int vertex, Vec2 u) const;
  /// Its density, per solid angle; zero outside the cone.
  float pdf_direction(uint32_t guide, int vertex, Vec3 direction) const;

  /// Density with which a guide goes on like this from a vertex, 1 ≤ vertex < length: of the
  /// direction where both scatter, 1 for the same specular event, 0 for another.
  double pdf_step(uint32_t guide, int vertex, const GuidedStep& step) const;

 private:
  struct Step {
    Vec3 axis;            // unit, of the segment that leaves
    float one_minus_cos;  // of the cone's half-angle
    PathEvent event;
  };
  struct Guide {
    uint32_t index_in_list;
    const Light* light;
    SurfacePoint origin;  // vertex 0
    Vec3 anchor;          // vertex 1, around which parallel rays start
    float disc_radius;
    std::vector<Step> steps;  // of each vertex but the last
  };

  // Densities are those of the position alone.
  std::optional<SurfacePoint> sample_disc(const Guide& guide, Vec2 u) const;
  double pdf_disc(const Guide& guide, const SurfacePoint& point) const;
  Ray parallel_ray(const Guide& guide, Vec3 direction, Vec2 u) const;
  double pdf_parallel(const Guide& guide, Vec3 ray_origin, Vec3 direction) const;

  std::shared_ptr<const Scene> scene_;
  std::vector<Guide> guides_;
  DiscreteDistribution weights_;
};

}  // namespace guidelight

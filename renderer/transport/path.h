#pragma once

#include <vector>

#include "renderer/scene/scene.h"

namespace guidelight {

/// A vertex of an explicit path and the edge from it towards the eye.
///
/// Densities and values are kept so that products along the path are contributions and densities in
/// the product measure of docs/metropolis.md: vertices on surfaces per area, a point light or a
/// pinhole discrete, a light at infinity per solid angle. At a delta vertex the delta functions of
/// value and density cancel, which leaves shares and probabilities.
struct PathPoint {
  SurfacePoint point;      // of a point light or the lens only the position; at infinity nothing
  Lobe event = kLobeNone;  // the delta lobe that scatters here; none where scattering is finite

  /// Value of scattering from the light's side to the eye's, cosine towards the eye included; at
  /// the light emitted radiance × cosine (intensity, irradiance …), at the lens We.
  Color value{0};
  float pdf_to_eye = 0;    // of the next vertex, coming from the light: per solid angle or discrete
  float pdf_to_light = 0;  // of the vertex before, coming from the eye, the same
  /// At a delta vertex: solid angles on the eye's side per those on the light's, with what radiance
  /// gains by refraction. Takes a discrete choice seen from the eye into the light's measure.
  float jacobian = 1;

  Vec3 direction{0};        // unit, to the next vertex
  float distance = 0;       // to the next vertex; infinite from a light at infinity
  float arrival_eye = 0;    // area at the next vertex per solid angle here, inverted: cosθ/d²
  float arrival_light = 0;  // the same at this vertex, seen from the next
  Color transmittance{1};   // on the way to the next vertex
};

/// An explicit path x₀ (light) … x_k (lens), the state of Markov chains. Mutations write vertices,
/// then update() what follows from them.
class Path {
 public:
  std::vector<PathPoint> points;
  const Light* light = nullptr;
  Vec2 raster{0};        // [pixels] where the path meets the picture
  int guide = kNoGuide;  // of a GuideMixture, that proposed the path

  static constexpr int kNoGuide = -1;

  int size() const { return static_cast<int>(points.size()); }
  /// Segments.
  int length() const { return size() - 1; }
  PathPoint& lens() { return points.back(); }
  const PathPoint& lens() const { return points.back(); }

  /// Makes this the first vertices of a path, new ones, and its last vertices. The new ones are
  /// whatever they were.
  void splice(const Path& path, int from_light, int inserted, int from_eye);

  /// Recomputes what depends on vertices [first, last]. False if the path carries nothing to the
  /// picture (visibility is not looked at).
  bool update(const Scene& scene, int first, int last);

  /// The measurement contribution f without the pixel filter, for a film of importance 1.
  const glm::dvec3& contribution() const { return contribution_; }
  /// Its luminance: the target of Markov chains.
  double target() const { return target_; }

  /// Density of vertex i if it is drawn from the light's (eye's) side, given those before it.
  double pdf_from_light(int i) const {
    return i == 0 ? pdf_light_ : double{points[i - 1].pdf_to_eye} * points[i - 1].arrival_eye;
  }
  double pdf_from_eye(int i) const;
  /// The probability that a path from the eye which finds x₀ takes it for this light's; 0 if the
  /// light cannot be hit.
  double hit_probability() const { return hit_probability_; }

  /// What the segment from vertex i to the next passes through; null is vacuum.
  const Medium* medium(const Scene& scene, int i) const;

  /// Whether vertices i - 1 and i may be joined by a connection. A light and the lens may not: what
  /// they see of each other is for paths from the eye.
  bool is_connectible_edge(int i) const;

  /// Whether scattering at an inner vertex is finite, or the vertex is an end of the path.
  bool is_finite(int i) const { return points[i].event == kLobeNone; }
  /// Largest index below `from` where the path may be joined when it is built from the eye: the
  /// first vertex of finite scattering, or 0.
  int next_finite_towards_light(int from) const;

 private:
  bool update_edge(const Scene& scene, int i);
  bool update_light(const Scene& scene);
  bool update_lens(const Scene& scene);
  bool update_scattering(int i);
  bool update_specular(int i);
  /// Calls visit(i, medium) for the segments from the lens to `first`.
  template <typename Visit>
  void visit_media(const Scene& scene, int first, Visit&& visit) const;
  void update_transmittance(const Scene& scene);
  void update_contribution();

  double pdf_light_ = 0;
  double pdf_lens_ = 0;
  double hit_probability_ = 0;
  glm::dvec3 contribution_{0};
  double target_ = 0;
};

/// The probability that a camera path which leaves the scene takes it for one of the lights at
/// infinity that can be hit; 0 without such lights.
float infinite_light_probability(const Scene& scene);

/// How many vertices two paths share from the light on (from the eye on): such as one kept of the
/// other. At the last of them, they may scatter differently.
int shared_from_light(const Path& a, const Path& b);
int shared_from_eye(const Path& a, const Path& b);

}  // namespace guidelight

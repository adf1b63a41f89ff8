#pragma once

#include <memory>

#include "renderer/metropolis/path_lengths.h"
#include "renderer/sampling/primary_samples.h"
#include "renderer/transport/guide_mixture.h"
#include "renderer/transport/path.h"

namespace guidelight {

/// Guides, and the share of new light's sides that follow one.
struct FollowedGuides {
  std::shared_ptr<const GuideMixture> mixture = nullptr;  // null: none
  float share = 0.5f;
};

/// Fills the gap between the first vertices and the last vertices of a path by every bidirectional
/// technique alike: some of the missing vertices continue the light's side, the others the eye's,
/// and a connection joins them (Veach 1997, 11.3.1). With nothing kept it draws whole paths.
///
/// Where the light's side is drawn from its beginning, a share of it follows guides as far as they
/// go, and from there the BSDFs. A light's side with density p for i vertices then has
///   (1 - a) p(i) + a Σ_j w_j p_j(i)
/// where guide j draws the first segments and BSDFs the others; a light alone is never guided.
class BidirectionalSampler {
 public:
  explicit BidirectionalSampler(const Scene& scene, FollowedGuides guides = {})
      : scene_(scene), guides_(std::move(guides)) {}

  void follow(FollowedGuides guides) { guides_ = std::move(guides); }

  /// What is kept of a path, and how many vertices are put in between. Of a side, either nothing is
  /// kept or at least two vertices: the light and the first direction are drawn together, as are
  /// the lens and the place in the picture.
  struct Gap {
    int from_light = 0;
    int inserted = 0;
    int from_eye = 0;

    bool is_possible() const;
  };

  /// `y` holds the kept vertices (Path::splice). False if the path is broken or carries nothing.
  /// Sets y.guide where a guide is followed. `Random` is Rng or PrimarySamples.
  template <typename Random>
  bool fill(const Gap& gap, Path& y, Random& rng) const;

  /// Density of the inserted vertices of y, over all techniques.
  double density(const Gap& gap, const Path& y) const;

 private:
  /// Techniques that fill a gap: from 0 to one less of its vertices continue the light's side.
  static int technique_count(const Gap& gap);
  template <typename Random>
  bool grow_from_light(const Gap& gap, int count, Path& y, Random& rng) const;
  template <typename Random>
  bool grow_along_guide(int count, Path& y, Random& rng) const;
  /// Draws the way on from vertex i as a guide does; its end is the next vertex.
  template <typename Random>
  bool follow_guide(uint32_t guide, int i, Path& y, Random& rng) const;
  template <typename Random>
  bool grow_from_eye(const Gap& gap, int count, Path& y, Random& rng) const;

  /// Densities of light's sides of y by their number of vertices, up to `most`.
  class LightSides;

  const Scene& scene_;
  FollowedGuides guides_;
};

/// Draws whole paths of all lengths, for seeding.
class PathSampler {
 public:
  PathSampler(const Scene& scene, const PathLengths& lengths, PathFilter filter = {});

  void follow(FollowedGuides guides) { sampler_.follow(std::move(guides)); }

  /// The path's density, over all techniques, or 0 if there is none; in the measure of Path.
  /// `Random` is Rng or PrimarySamples.
  template <typename Random>
  double sample(Path& path, Random& rng) const;

  /// The density of a path that passes the filter.
  double density(const Path& path) const;

 private:
  static BidirectionalSampler::Gap whole(int length) {
    return {.from_light = 0, .inserted = length + 1, .from_eye = 0};
  }

  BidirectionalSampler sampler_;
  PathLengths lengths_;
  PathFilter filter_;
  DiscreteDistribution distribution_;  // of lengths from lengths_.min on
};

}  // namespace guidelight

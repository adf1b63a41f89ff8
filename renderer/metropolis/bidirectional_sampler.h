#pragma once

#include "renderer/metropolis/path_lengths.h"
#include "renderer/sampling/primary_samples.h"
#include "renderer/transport/path.h"

namespace guidelight {

/// Fills the gap between the first vertices and the last vertices of a path by every bidirectional
/// technique alike: some of the missing vertices continue the light's side, the others the eye's,
/// and a connection joins them (Veach 1997, 11.3.1). With nothing kept it draws whole paths.
class BidirectionalSampler {
 public:
  explicit BidirectionalSampler(const Scene& scene) : scene_(scene) {}

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
  /// `Random` is Rng or PrimarySamples.
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
  bool grow_from_eye(const Gap& gap, int count, Path& y, Random& rng) const;

  const Scene& scene_;
};

/// Draws whole paths of all lengths, for seeding.
class PathSampler {
 public:
  PathSampler(const Scene& scene, const PathLengths& lengths, PathFilter filter = {});

  /// The path's density, over all techniques, or 0 if there is none; in the measure of Path.
  /// `Random` is Rng or PrimarySamples.
  template <typename Random>
  double sample(Path& path, Random& rng) const;

 private:
  BidirectionalSampler sampler_;
  PathLengths lengths_;
  PathFilter filter_;
  DiscreteDistribution distribution_;  // of lengths from lengths_.min on
};

}  // namespace guidelight

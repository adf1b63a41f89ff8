#pragma once

#include <vector>

#include "renderer/metropolis/bidirectional_sampler.h"
#include "renderer/parallel/parallel.h"

namespace guidelight {

/// How much light all paths together bring to the picture, and where chains start: independent
/// paths, of which a chain takes one in proportion to what it carries over its density. Such a
/// start is a draw from the chain's target, up to the finite number of paths: there is no start-up
/// phase to wait for (Veach 1997, 11.3.1).
class Seeding {
 public:
  Seeding(const Scene& scene, const PathLengths& lengths, PathFilter filter = {})
      : sampler_(scene, lengths, std::move(filter)) {}

  /// From now on a share of the paths follows these guides; null for none.
  void follow(std::shared_ptr<const GuideMixture> guides);

  /// Is shown the i-th path of a draw and its density; only paths that carry light, from many
  /// threads at once.
  using Observer = std::function<void(size_t i, const Path& path, double pdf)>;

  /// Draws `count` more paths, numbered by (seed, pass); chains may start from these.
  void draw(size_t count, uint64_t seed, uint64_t pass, Parallel& parallel,
            const Observer& observe = {});

  /// B, the integral of the target: the mean over all paths drawn so far, and its standard error.
  double normalization() const { return count_ > 0 ? sum_ / static_cast<double>(count_) : 0; }
  double standard_error() const;

  /// Random numbers with which sampler() draws the start of one of `chains` chains: a path of the
  /// last draw. To be called where can_start().
  Rng start(size_t chain, size_t chains) const;
  /// That path.
  Path start_path(size_t chain, size_t chains) const;
  /// Whether a path of the last draw carries light.
  bool can_start() const { return has_starts_; }
  const PathSampler& sampler() const { return sampler_; }

 private:
  PathSampler sampler_;
  double sum_ = 0;
  double squares_ = 0;
  uint64_t count_ = 0;
  // Of the last draw.
  uint64_t seed_ = 0;
  uint64_t pass_ = 0;
  DiscreteDistribution starts_;
  bool has_starts_ = false;
};

}  // namespace guidelight

#pragma once

#include <array>

#include "renderer/image/film.h"
#include "renderer/metropolis/bidirectional_sampler.h"
#include "renderer/sampling/random.h"
#include "renderer/transport/path.h"

namespace guidelight {

/// What a path brings to the film: f/Y(f), a colour of luminance 1.
Splat splat_of(const Path& path);

/// Chains and the independent paths from which they start are two ways to sample the same picture:
/// N states of density Y(f)/B, and M paths of density q. By the balance heuristic (Veach 1997,
/// 9.2.2.1) each sample, of either, counts
///   f / ( N·Y(f)/B + M·q )
/// so that no state of a chain is brighter than an independent path, and guides that the paths
/// follow help at once.
struct ChainShare {
  double normalization;  // B
  double states = 1;     // N
  double paths = 0;      // M; 0: the film takes the states alone

  /// Luminance of a sample, for a film whose sums are divided by N.
  double luminance(double target, double pdf) const {
    return target * states / (states * target / normalization + paths * pdf);
  }
};

/// Takes the states of a chain to the film, some at a time.
class FilmObserver {
 public:
  /// `sampler` draws the independent paths; it must outlive this. `rng` is for the pixel filter.
  FilmObserver(Film& film, const ChainShare& share, const PathSampler& sampler, Rng rng)
      : film_(film), share_(share), sampler_(sampler), rng_(rng) {}

  /// A state of the chain.
  void operator()(const Path& path, double weight);
  /// What splat_of() says, times a weight.
  void add(Splat splat, double weight);
  /// To be called at the end.
  void flush();

 private:
  static constexpr size_t kBatch = 64;

  Film& film_;
  ChainShare share_;
  const PathSampler& sampler_;
  Rng rng_;
  std::array<Splat, kBatch> splats_;
  std::array<Vec2, kBatch> offsets_;
  size_t count_ = 0;
};

/// L S⁺ D S* E, D being whatever is not specular.
bool is_caustic(const Path& path);

}  // namespace guidelight

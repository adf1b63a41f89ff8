#pragma once

#include <string>

#include "renderer/sampling/random.h"
#include "renderer/transport/path.h"

namespace guidelight {

/// One way in which a Markov chain over explicit paths proposes its next state. Densities are in
/// the product measure of Path, so that their quotient in both directions belongs into the
/// acceptance probability (Veach 1997, 11.2). Immutable; may be used by many chains at once.
class Mutation {
 public:
  virtual ~Mutation() = default;

  /// As on the command line and in statistics.
  virtual std::string name() const = 0;

  /// Whether paths of this form can be mutated so. Depends on how the path scatters, not on where.
  virtual bool is_suitable(const Path& x) const = 0;

  /// Draws a candidate from a suitable path. False where there is none, which is a rejection.
  /// The candidate is complete: updated, visible, of positive target.
  virtual bool propose(const Path& x, Path& y, Rng& rng) const = 0;

  /// Density of drawing y from a suitable x.
  virtual double density(const Path& x, const Path& y) const = 0;
};

}  // namespace guidelight

#pragma once

#include <cstdint>
#include <vector>

#include "renderer/sampling/random.h"

namespace guidelight {

/// The random numbers of one path as a point of the unit hypercube that can be mutated (Kelemen et
/// al. 2002): used in place of an Rng, it answers with the numbers of the current candidate.
/// Coordinates come into being, and are mutated, when they are asked for.
class PrimarySamples {
 public:
  /// The first candidate takes its numbers from `rng` as they come, as a path would.
  explicit PrimarySamples(Rng rng) : rng_(rng) {}

  /// Begins a candidate: a new point, or a neighbour of the current one.
  void propose(bool large_step);
  void accept();
  void reject();

  float next_float();
  Vec2 next_vec2() {
    const float x = next_float();
    return {x, next_float()};
  }

  /// The stream behind it, for decisions between candidates.
  Rng& rng() { return rng_; }

 private:
  struct Coordinate {
    float value = 0;
    uint64_t time = 0;  // of the last mutation
    float old_value = 0;
    uint64_t old_time = 0;
  };

  /// Brings a coordinate up to the candidate.
  void update(Coordinate& coordinate);

  Rng rng_;
  std::vector<Coordinate> coordinates_;
  size_t next_ = 0;
  uint64_t time_ = 0;             // of the candidate
  uint64_t last_large_step_ = 0;  // accepted
  bool large_step_ = true;
};

}  // namespace guidelight

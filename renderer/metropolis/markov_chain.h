#pragma once

#include <memory>
#include <vector>

#include "renderer/metropolis/mutation.h"
#include "renderer/metropolis/path_lengths.h"

namespace guidelight {

/// What became of the proposals of one mutation.
struct MutationStatistics {
  uint64_t proposed = 0;
  double accepted = 0;      // sum of acceptance probabilities
  double contribution = 0;  // sum of the weights that states of its making had

  void add(const MutationStatistics& other) {
    proposed += other.proposed;
    accepted += other.accepted;
    contribution += other.contribution;
  }
};

/// The mutations that chains use, each with the probability of being chosen. A path is mutated by
/// one of those that suit its form; their probabilities are scaled to sum to 1.
class MutationSet {
 public:
  /// Those of weight 0 are left out.
  void add(std::unique_ptr<Mutation> mutation, float weight);

  size_t size() const { return entries_.size(); }
  const Mutation& operator[](size_t i) const { return *entries_[i].mutation; }

  /// Sum of the weights of those that suit a path.
  float suitable_weight(const Path& x) const;
  /// One of them: that at `remaining` of their weights, below suitable_weight(x).
  size_t choose(const Path& x, float remaining) const;

 private:
  struct Entry {
    std::unique_ptr<Mutation> mutation;
    float weight;
  };
  std::vector<Entry> entries_;
};

/// A Markov chain whose states are paths, distributed by the luminance that they carry (Veach 1997,
/// chapter 11). An observer is shown all states and all candidates, each with its expected weight;
/// the weights of n steps sum to n.
class MarkovChain {
 public:
  /// `mutations` must outlive this. `start` must carry light and pass the filter.
  MarkovChain(const MutationSet& mutations, Path start, Rng rng, PathFilter filter = {});

  /// Calls observe(path, weight) with weights that are expected values.
  template <typename Observe>
  void run(uint64_t steps, Observe&& observe);

  /// Goes on from another path, which must be such as the first; what was counted stays.
  void restart(Path start, Rng rng);
  uint64_t restarts() const { return restarts_; }

  /// Steps taken so far.
  uint64_t steps() const { return steps_; }
  /// By index in the set.
  const std::vector<MutationStatistics>& statistics() const { return statistics_; }
  /// By guide; those that have proposed nothing may be missing at the end.
  const std::vector<MutationStatistics>& guide_statistics() const { return guide_statistics_; }
  /// To be called when the set has others, and with them other weights.
  void forget_guides();

 private:
  /// Proposes a candidate: the probability of accepting it.
  double propose(size_t mutation);
  template <typename Observe>
  void show(const Path& path, double weight, size_t origin, Observe& observe);
  MutationStatistics& of_guide(int guide);

  const MutationSet& mutations_;
  PathFilter filter_;
  Rng rng_;
  Path current_;
  Path candidate_;
  float suitable_weight_;  // of the current path
  uint64_t steps_ = 0;
  uint64_t restarts_ = 0;
  size_t origin_ = 0;  // mutation that proposed the current path
  double weight_ = 0;  // of the current path, not shown yet
  std::vector<MutationStatistics> statistics_;
  std::vector<MutationStatistics> guide_statistics_;
};

template <typename Observe>
void MarkovChain::show(const Path& path, double weight, size_t origin, Observe& observe) {
  if (weight == 0) return;
  statistics_[origin].contribution += weight;
  if (path.guide != Path::kNoGuide) of_guide(path.guide).contribution += weight;
  observe(path, weight);
}

template <typename Observe>
void MarkovChain::run(uint64_t steps, Observe&& observe) {
  for (uint64_t step = 0; step < steps; ++step) {
    const size_t mutation = mutations_.choose(current_, rng_.next_float() * suitable_weight_);
    const double acceptance = propose(mutation);
    statistics_[mutation].proposed += 1;
    statistics_[mutation].accepted += acceptance;
    if (candidate_.guide != Path::kNoGuide) {
      of_guide(candidate_.guide).proposed += 1;
      of_guide(candidate_.guide).accepted += acceptance;
    }
    weight_ += 1 - acceptance;
    if (acceptance > 0 && rng_.next_float() < acceptance) {
      show(current_, weight_, origin_, observe);
      std::swap(current_, candidate_);
      suitable_weight_ = mutations_.suitable_weight(current_);
      origin_ = mutation;
      weight_ = acceptance;
    } else {
      show(candidate_, acceptance, mutation, observe);
    }
  }
  show(current_, weight_, origin_, observe);
  weight_ = 0;
  steps_ += steps;
}

}  // namespace guidelight

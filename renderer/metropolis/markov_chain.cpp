#include "renderer/metropolis/markov_chain.h"

#include <algorithm>

namespace guidelight {

void MutationSet::add(std::unique_ptr<Mutation> mutation, float weight) {
  if (weight > 0) entries_.push_back({std::move(mutation), weight});
}

float MutationSet::suitable_weight(const Path& x) const {
  float sum = 0;
  for (const Entry& entry : entries_) sum += entry.mutation->is_suitable(x) ? entry.weight : 0.0f;
  return sum;
}

size_t MutationSet::choose(const Path& x, float remaining) const {
  size_t last = 0;
  for (size_t i = 0; i < entries_.size(); ++i) {
    if (!entries_[i].mutation->is_suitable(x)) continue;
    last = i;
    remaining -= entries_[i].weight;
    if (remaining < 0) break;
  }
  return last;
}

MarkovChain::MarkovChain(const MutationSet& mutations, Path start, Rng rng, PathFilter filter)
    : mutations_(mutations),
      filter_(std::move(filter)),
      rng_(rng),
      current_(std::move(start)),
      suitable_weight_(mutations.suitable_weight(current_)),
      statistics_(mutations.size()) {}

void MarkovChain::restart(Path start, Rng rng) {
  rng_ = rng;
  current_ = std::move(start);
  suitable_weight_ = mutations_.suitable_weight(current_);
  origin_ = 0;
  ++restarts_;
}

double MarkovChain::propose(size_t which) {
  const Mutation& mutation = mutations_[which];
  if (!mutation.propose(current_, candidate_, rng_)) return 0;
  if (filter_ && !filter_(candidate_)) return 0;
  const double forward = mutation.density(current_, candidate_);
  if (!(forward > 0) || !mutation.is_suitable(candidate_)) return 0;
  // Metropolis–Hastings (Veach 1997, 11.6); the set's choice belongs to the density.
  const double backward = mutation.density(candidate_, current_) * suitable_weight_ /
                          mutations_.suitable_weight(candidate_);
  const double ratio = candidate_.target() * backward / (current_.target() * forward);
  return ratio > 0 ? std::min(ratio, 1.0) : 0;  // not a number where both densities are infinite
}

MutationStatistics& MarkovChain::of_guide(int guide) {
  const auto index = static_cast<size_t>(guide);
  if (index >= guide_statistics_.size()) guide_statistics_.resize(index + 1);
  return guide_statistics_[index];
}

void MarkovChain::forget_guides() {
  guide_statistics_.clear();
  current_.guide = Path::kNoGuide;
  suitable_weight_ = mutations_.suitable_weight(current_);
}

}  // namespace guidelight

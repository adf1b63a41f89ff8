#pragma once

#include "renderer/metropolis/bidirectional_sampler.h"
#include "renderer/metropolis/markov_chain.h"

namespace guidelight {

/// A Markov chain over the random numbers that make a path (Kelemen et al. 2002), distributed by
/// the luminance of the path over its density. Observed like a MarkovChain.
class PrimaryChain {
 public:
  /// `sampler` must outlive this.
  PrimaryChain(const PathSampler& sampler, float large_steps)
      : sampler_(sampler), large_steps_(large_steps) {}

  /// Begins, or begins anew; what was counted stays. With `first` the sampler must draw a path that
  /// carries light. `rng` is for what follows: chains may share their first path.
  void start(Rng first, Rng rng) {
    samples_ = PrimarySamples(first);
    value_ = evaluate(current_);
    samples_.rng() = rng;
    origin_ = true;
  }

  template <typename Observe>
  void run(uint64_t steps, Observe&& observe);

  uint64_t steps() const { return steps_; }
  /// Of small and of large steps.
  const MutationStatistics& small_steps() const { return statistics_[0]; }
  const MutationStatistics& large_steps() const { return statistics_[1]; }

 private:
  double evaluate(Path& path) {
    const double pdf = sampler_.sample(path, samples_);
    return pdf > 0 ? path.target() / pdf : 0;
  }

  const PathSampler& sampler_;
  PrimarySamples samples_{Rng(0, 0, 0)};
  float large_steps_;
  Path current_;
  Path candidate_;
  double value_ = 0;   // of the current path
  double weight_ = 0;  // of the current path, not shown yet
  uint64_t steps_ = 0;
  bool origin_ = true;  // whether a large step proposed the current path
  MutationStatistics statistics_[2];
};

template <typename Observe>
void PrimaryChain::run(uint64_t steps, Observe&& observe) {
  const auto show = [&](const Path& path, double weight, bool origin) {
    if (weight == 0) return;
    statistics_[origin].contribution += weight;
    observe(path, weight);
  };
  for (uint64_t step = 0; step < steps; ++step) {
    const bool large_step = samples_.rng().next_float() < large_steps_;
    samples_.propose(large_step);
    const double value = evaluate(candidate_);
    const double acceptance = std::min(1.0, value / value_);
    statistics_[large_step].proposed += 1;
    statistics_[large_step].accepted += acceptance;
    weight_ += 1 - acceptance;
    if (acceptance > 0 && samples_.rng().next_float() < acceptance) {
      samples_.accept();
      show(current_, weight_, origin_);
      std::swap(current_, candidate_);
      value_ = value;
      origin_ = large_step;
      weight_ = acceptance;
    } else {
      samples_.reject();
      show(candidate_, acceptance, large_step);
    }
  }
  show(current_, weight_, origin_);
  weight_ = 0;
  steps_ += steps;
}

}  // namespace guidelight

#include "renderer/metropolis/seeding.h"

#include <algorithm>
#include <cmath>

namespace guidelight {

namespace {

/// Random numbers of path i; chains have other streams.
constexpr uint64_t kSeedStream = 0x5eed;

Rng path_rng(uint64_t seed, uint64_t pass, size_t i) { return {seed ^ kSeedStream, pass, i}; }

}  // namespace

void Seeding::follow(std::shared_ptr<const GuideMixture> guides) {
  constexpr float kGuideShare = 0.3f;
  sampler_.follow({std::move(guides), kGuideShare});
}

void Seeding::draw(size_t count, uint64_t seed, uint64_t pass, Parallel& parallel,
                   const Observer& observe) {
  constexpr size_t kBatch = 1000;
  seed_ = seed;
  pass_ = pass;
  std::vector<float> weights(count);
  parallel.for_each((count + kBatch - 1) / kBatch, [&](size_t batch) {
    Path path;
    for (size_t i = batch * kBatch; i < std::min((batch + 1) * kBatch, count); ++i) {
      Rng rng = path_rng(seed, pass, i);
      const double pdf = sampler_.sample(path, rng);
      if (!(pdf > 0)) continue;
      weights[i] = static_cast<float>(path.target() / pdf);
      if (observe) observe(i, path, pdf);
    }
  });
  for (const float weight : weights) sum_ += weight, squares_ += sqr(double{weight});
  count_ += count;
  starts_ = DiscreteDistribution(weights);
  has_starts_ = std::ranges::any_of(weights, [](float weight) { return weight > 0; });
}

double Seeding::standard_error() const {
  const auto n = static_cast<double>(count_);
  return n > 1 ? std::sqrt(std::max(squares_ / n - sqr(sum_ / n), 0.0) / (n - 1)) : 0;
}

Rng Seeding::start(size_t chain, size_t chains) const {
  // Stratified: as many chains as possible start from different paths.
  const float jitter = Rng(seed_ ^ ~kSeedStream, pass_, chain).next_float();
  const auto u = (static_cast<float>(chain) + jitter) / static_cast<float>(chains);
  const uint32_t chosen = starts_.sample(std::min(u, kOneMinusEpsilon)).index;
  return path_rng(seed_, pass_, chosen);
}

Path Seeding::start_path(size_t chain, size_t chains) const {
  Rng rng = start(chain, chains);
  Path path;
  sampler_.sample(path, rng);
  return path;
}

}  // namespace guidelight

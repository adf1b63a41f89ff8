#pragma once

#include <memory>
#include <vector>

#include "renderer/metropolis/markov_chain.h"
#include "renderer/transport/guide_mixture.h"

namespace guidelight {

/// How often each mutation is tried, relative to the others.
struct MutationWeights {
  float bidirectional = 0;  // BD
  float guided = 0;         // UP; counts where there are guides
  float lens = 0;           // LP
  float caustic = 0;        // CP
  float multi_chain = 0;
  float lens_subpath = 0;                 // LS
  float photon_map = 0;                   // PM
  float max_angle = glm::radians(30.0f);  // γ of the photon map perturbation [rad]
};

/// Chains that share their mutations, and follow guides that may change.
class GuidedChains {
 public:
  /// Throws Error if the chains could not reach every path. `scene` must outlive this.
  GuidedChains(const Scene& scene, const PathLengths& lengths, const MutationWeights& weights,
               PathFilter filter = {});

  /// From now on the chains follow these guides; null for none.
  void follow(const std::shared_ptr<const GuideMixture>& guides);

  /// Lets chain i, which is the next new one or exists, go on from a path that carries light.
  void start(size_t i, Path path, Rng rng);

  const MutationSet& mutations() const { return mutations_; }
  const GuideMixture* guides() const { return guides_.get(); }
  std::vector<MarkovChain>& list() { return chains_; }
  const std::vector<MarkovChain>& list() const { return chains_; }

 private:
  void make_mutations();

  const Scene& scene_;
  PathLengths lengths_;
  MutationWeights weights_;
  PathFilter filter_;
  std::shared_ptr<const GuideMixture> guides_;
  MutationSet mutations_;
  std::vector<MarkovChain> chains_;
};

}  // namespace guidelight

#include "renderer/metropolis/guided_chains.h"

#include "renderer/error.h"
#include "renderer/metropolis/bidirectional_mutation.h"
#include "renderer/metropolis/caustic_perturbation.h"
#include "renderer/metropolis/eye_perturbations.h"
#include "renderer/metropolis/lens_subpath_mutation.h"

namespace guidelight {

GuidedChains::GuidedChains(const Scene& scene, const PathLengths& lengths,
                           const MutationWeights& weights, PathFilter filter)
    : scene_(scene), lengths_(lengths), weights_(weights), filter_(std::move(filter)) {
  if (weights.bidirectional == 0) {
    throw Error(
        "without bidirectional mutations a chain cannot reach every path: give 'bidirectional' "
        "more "
        "than 0");
  }
  make_mutations();
}

void GuidedChains::make_mutations() {
  // UP and BD are one hybrid proposal (Fan et al. 2005, section 5.2).
  const float hybrid = weights_.bidirectional + (guides_ ? weights_.guided : 0.0f);
  mutations_ = {};
  mutations_.add(make_bidirectional_mutation(scene_, lengths_, guides_, weights_.guided / hybrid),
                 hybrid);
  mutations_.add(make_lens_perturbation(scene_), weights_.lens);
  mutations_.add(make_caustic_perturbation(scene_), weights_.caustic);
  mutations_.add(make_multi_chain_perturbation(scene_), weights_.multi_chain);
  mutations_.add(make_lens_subpath_mutation(scene_, lengths_), weights_.lens_subpath);
  mutations_.add(make_photon_map_perturbation(scene_, weights_.max_angle), weights_.photon_map);
}

void GuidedChains::follow(const std::shared_ptr<const GuideMixture>& guides) {
  if (guides == guides_) return;
  guides_ = guides;
  make_mutations();
  for (MarkovChain& chain : chains_) chain.forget_guides();
}

void GuidedChains::start(size_t i, Path path, Rng rng) {
  if (i < chains_.size()) {
    chains_[i].restart(std::move(path), rng);
  } else {
    chains_.emplace_back(mutations_, std::move(path), rng, filter_);
  }
}

}  // namespace guidelight

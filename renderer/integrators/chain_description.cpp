#include "renderer/integrators/chain_description.h"

namespace guidelight {

namespace {

ProposalStatistics describe(const std::string& name, const MutationStatistics& counted,
                            uint64_t steps) {
  const auto total = static_cast<double>(std::max<uint64_t>(steps, 1));
  const auto proposed = static_cast<double>(std::max<uint64_t>(counted.proposed, 1));
  return {.name = name,
          .share = static_cast<double>(counted.proposed) / total,
          .acceptance = counted.accepted / proposed,
          .contribution = counted.contribution / total};
}

ChainStatistics brightness(const Seeding& seeding) {
  ChainStatistics result;
  result.normalization = seeding.normalization();
  result.normalization_error = seeding.standard_error();
  return result;
}

}  // namespace

ChainStatistics describe_chains(const GuidedChains& chains, const Seeding& seeding) {
  const MutationSet& mutations = chains.mutations();
  const GuideMixture* guides = chains.guides();
  std::vector<MutationStatistics> of_mutation(mutations.size());
  std::vector<MutationStatistics> of_guide(guides ? guides->size() : 0);
  ChainStatistics result = brightness(seeding);
  double accepted = 0;
  for (const MarkovChain& chain : chains.list()) {
    result.steps += chain.steps();
    result.restarts += chain.restarts();
    for (size_t i = 0; i < of_mutation.size(); ++i) of_mutation[i].add(chain.statistics()[i]);
    const auto& counted = chain.guide_statistics();
    for (size_t i = 0; i < std::min(of_guide.size(), counted.size()); ++i) {
      of_guide[i].add(counted[i]);
    }
  }
  for (size_t i = 0; i < mutations.size(); ++i) {
    result.mutations.push_back(describe(mutations[i].name(), of_mutation[i], result.steps));
    accepted += of_mutation[i].accepted;
  }
  for (size_t i = 0; i < of_guide.size(); ++i) {
    const size_t index = guides->index_in_list(static_cast<uint32_t>(i));
    result.guides.resize(std::max(result.guides.size(), index + 1));
    result.guides[index] = describe("", of_guide[i], result.steps);
  }
  if (result.steps > 0) result.acceptance = accepted / static_cast<double>(result.steps);
  return result;
}

ChainStatistics describe_chains(std::span<const PrimaryChain> chains, const Seeding& seeding) {
  ChainStatistics result = brightness(seeding);
  MutationStatistics small, large;
  for (const PrimaryChain& chain : chains) {
    result.steps += chain.steps();
    small.add(chain.small_steps());
    large.add(chain.large_steps());
  }
  result.mutations = {describe("small_step", small, result.steps),
                      describe("large_step", large, result.steps)};
  if (result.steps > 0) {
    result.acceptance = (small.accepted + large.accepted) / static_cast<double>(result.steps);
  }
  return result;
}

}  // namespace guidelight

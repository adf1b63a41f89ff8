#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace guidelight {

/// What became of the proposals of one kind since the chains began.
struct ProposalStatistics {
  std::string name;         // of the mutation; empty for a guide
  double share = 0;         // of all proposals
  double acceptance = 0;    // mean acceptance probability; 0 if nothing was proposed
  double contribution = 0;  // share of the chains' light that it has found
};

/// How Markov chains fare.
struct ChainStatistics {
  std::vector<ProposalStatistics> mutations;
  std::vector<ProposalStatistics> guides;  // by the position in the list of guides
  uint64_t steps = 0;
  uint64_t restarts = 0;           // of chains that went on from an independent path
  double acceptance = 0;           // of all proposals
  double normalization = 0;        // B: mean luminance of what the chains show
  double normalization_error = 0;  // its standard error
};

}  // namespace guidelight

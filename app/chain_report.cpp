#include "app/chain_report.h"

#include <fmt/format.h>

namespace guidelight {

namespace {

std::string row(const std::string& name, const ProposalStatistics& proposals) {
  return fmt::format("{:<16}{:>9.2f} %{:>9.2f} %{:>9.2f} %\n", name, 100 * proposals.share,
                     100 * proposals.acceptance, 100 * proposals.contribution);
}

}  // namespace

std::string chain_report(const ChainStatistics& chains) {
  std::string text = fmt::format("{:<16}{:>11}{:>11}{:>11}\n", "", "proposed", "accepted", "light");
  for (const ProposalStatistics& mutation : chains.mutations) text += row(mutation.name, mutation);
  for (size_t i = 0; i < chains.guides.size(); ++i) {
    if (chains.guides[i].share > 0) text += row(fmt::format("guide {}", i + 1), chains.guides[i]);
  }
  text +=
      fmt::format("{} mutations, {:.2f} % accepted, {} restarts, mean luminance {:.5g} +- {:.2g}\n",
                  chains.steps, 100 * chains.acceptance, chains.restarts, chains.normalization,
                  chains.normalization_error);
  return text;
}

}  // namespace guidelight

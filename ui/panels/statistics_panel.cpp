#include <fmt/format.h>

#include <algorithm>

#include "renderer/parallel/process_memory.h"
#include "ui/forecast.h"
#include "ui/format.h"
#include "ui/panels/panels.h"
#include "ui/proposal_table.h"
#include "ui/widgets.h"

namespace guidelight {
namespace {

/// Goals that are tried when the person has set none: each a third of the one before.
constexpr double kErrorGoals[] = {0.3, 0.1, 0.03, 0.01, 0.003, 0.001};

double error_goal(const RenderTargets& targets, double error) {
  if (targets.relative_error > 0) return targets.relative_error;
  for (const double goal : kErrorGoals) {
    if (goal < error) return goal;
  }
  return error / 2;
}

void draw_error(const Document& document) {
  const Snapshot& status = document.status();
  if (status.passes < 2 || !(status.relative_error > 0)) {
    readout("Error", "after two passes");
    return;
  }
  readout("Error", format_percent(status.relative_error),
          "Estimated relative standard error of a pixel, mean over the picture");
  const double goal = error_goal(document.settings().targets, status.relative_error);
  const double left = seconds_until_error(status.seconds, status.relative_error, goal);
  readout(("To " + format_percent(goal)).c_str(),
          left > 0 ? "in " + format_duration(left) : "reached",
          "Time left until the estimated error is that small, if it goes on falling with the root "
          "of the time. Set \"or at error\" on the left for another goal.");
}

void draw_chains(const ChainStatistics& chains) {
  readout("Accepted", format_percent(chains.acceptance), "Of all proposals of the Markov chains");
  readout("Proposals", format_count(static_cast<double>(chains.steps)), "Since the chains began");
  std::vector<ProposalRow> rows;
  for (const ProposalStatistics& mutation : chains.mutations) {
    std::string name = mutation.name;  // a key
    std::ranges::replace(name, '_', ' ');
    rows.push_back({name, mutation});
  }
  draw_proposal_table("mutations", "Mutation", rows);
}

}  // namespace

void draw_statistics_panel(const Document& document) {
  if (!document.has_scene() || !section("Statistics")) return;
  const Snapshot& status = document.status();
  readout("Passes", format_count(status.passes));
  readout("Time", format_duration(status.seconds), "Spent rendering, pauses excluded");
  if (status.seconds > 0) {
    readout("Samples", format_count(static_cast<double>(status.samples) / status.seconds) + "/s",
            "Of pixels, mean since the render began");
  }
  if (status.rays_per_second > 0) {
    readout("Rays", format_count(status.rays_per_second) + "/s",
            "Traced by Embree for paths, connections and shadows, mean since the render began");
  }
  draw_error(document);
  if (const auto& picture = document.picture();
      picture && picture->photons && picture->photons->total > 0) {
    const PhotonCloud& photons = *picture->photons;
    readout("Photons",
            format_count(static_cast<double>(photons.total)) + " in " + format_bytes(photons.bytes),
            "Of one pass");
  }
  readout("Memory", format_bytes(resident_bytes()), "That the whole program holds");
  if (status.chains) draw_chains(*status.chains);
}

}  // namespace guidelight

#pragma once

#include <imgui.h>

#include <optional>
#include <string>
#include <vector>

#include "renderer/integrators/chain_statistics.h"

namespace guidelight {

/// A line of a table of what Markov chains propose.
struct ProposalRow {
  std::string name;
  ProposalStatistics statistics;
  ImU32 color = 0;  // of a mark before the name; 0 for none
  bool selected = false;
};

enum class ProposalColumn { Name, Proposed, Accepted, Light };

/// The order of the rows by a column, names upwards and numbers as asked.
std::vector<size_t> sorted_rows(const std::vector<ProposalRow>& rows, ProposalColumn by,
                                bool ascending);

/// The table, sorted by the column whose heading is clicked. Returns the row that was clicked.
std::optional<size_t> draw_proposal_table(const char* id, const char* heading,
                                          const std::vector<ProposalRow>& rows);

}  // namespace guidelight

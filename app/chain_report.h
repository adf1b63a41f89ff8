#pragma once

#include <string>

#include "renderer/integrators/chain_statistics.h"

namespace guidelight {

/// How Markov chains fared, as a table for a terminal; guides by number, those without proposals
/// left out.
std::string chain_report(const ChainStatistics& chains);

}  // namespace guidelight

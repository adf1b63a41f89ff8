#pragma once

#include <functional>

namespace guidelight {

class Path;

/// Longest path of chains, in segments.
constexpr int kLongestPath = 64;

/// The paths that a chain visits, by their number of segments: at most kLongestPath.
struct PathLengths {
  int min = 1;
  int max = 12;

  bool contains(int length) const { return length >= min && length <= max; }
};

/// Which paths count for a chain; empty for all. The others carry nothing to it.
using PathFilter = std::function<bool(const Path&)>;

}  // namespace guidelight

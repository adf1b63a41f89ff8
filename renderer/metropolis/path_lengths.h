#pragma once

namespace guidelight {

/// The paths that a chain visits, by their number of segments.
struct PathLengths {
  int min = 1;
  int max = 12;

  bool contains(int length) const { return length >= min && length <= max; }
};

}  // namespace guidelight

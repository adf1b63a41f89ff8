#pragma once

#include <string>

#include "renderer/session/snapshot.h"

namespace guidelight {

/// Shows how a render gets on: one line that is redrawn on a terminal, otherwise a plain line every
/// few seconds. Writes to standard error.
class ProgressBar {
 public:
  ProgressBar();
  void show(const Snapshot& snapshot);
  /// Ends the redrawn line.
  void finish(const Snapshot& snapshot);

 private:
  bool is_terminal_;
  double next_line_ = 0;  // [s] of render time
};

}  // namespace guidelight

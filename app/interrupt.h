#pragma once

namespace guidelight {

/// While it lives, Ctrl-C and the termination signal set a flag instead of ending the program.
/// A second one, at least half a second later, ends it.
class InterruptGuard {
 public:
  InterruptGuard();
  ~InterruptGuard();
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

  bool interrupted() const;
};

}  // namespace guidelight

#pragma once

#include "renderer/session/render_session.h"

namespace guidelight {

/// Who watches a render. Called on the thread that renders.
class RenderObserver {
 public:
  virtual ~RenderObserver() = default;
  /// Time spent on this job, pauses excluded [s].
  virtual double seconds() const = 0;
  /// Whether the unfinished last pass of a job that is given up should still be shown and saved.
  virtual bool wants_unfinished() const = 0;
  virtual void publish(Snapshot snapshot) = 0;
};

/// Renders one job pass after pass on the calling thread, until a target is reached or `control`
/// asks to stop (then Stopped is thrown). Snapshots are published after coarse pictures, after the
/// first pass, and then so that publishing takes a small share of the time.
void render_progressively(const RenderJob& job, WorkControl& control, RenderObserver& observer);

}  // namespace guidelight

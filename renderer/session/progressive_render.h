#pragma once

#include <vector>

#include "renderer/session/render_session.h"

namespace guidelight {

/// Who watches a render and has a say in it. Called on the thread that renders.
class RenderObserver {
 public:
  virtual ~RenderObserver() = default;
  /// Time spent on this job, pauses excluded [s].
  virtual double seconds() const = 0;
  /// Whether the unfinished last pass of a job that is given up should still be shown and saved.
  virtual bool wants_unfinished() const = 0;
  virtual void publish(Snapshot snapshot) = 0;
  /// When to stop, as things stand now.
  virtual RenderTargets targets() const = 0;
  /// Which guides to follow in the next pass.
  virtual GuideList guides() const = 0;
  /// Where techniques are kept apart in the next pass; null for nowhere.
  virtual std::shared_ptr<TechniqueImages> techniques() const = 0;
  /// Who has asked for the progress since this was called last.
  virtual std::vector<SaveProgress> take_save_requests() = 0;
  /// How many photons should be handed over with each picture; 0 for none.
  virtual size_t photons_wanted() const = 0;
  /// Waits for other targets or for somebody who wants the progress. Throws Stopped.
  virtual void rest() = 0;
};

/// Renders one job pass after pass on the calling thread, and rests when a target is reached, until
/// `control` asks to stop. Snapshots are published after coarse pictures, after the first pass, and
/// then so that publishing takes a small share of the time. Ends by throwing Stopped, or what went
/// wrong.
[[noreturn]] void render_progressively(const RenderJob& job, WorkControl& control,
                                       RenderObserver& observer);

}  // namespace guidelight

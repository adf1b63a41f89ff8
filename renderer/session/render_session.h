#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "renderer/integrators/integrator.h"
#include "renderer/session/snapshot.h"
#include "renderer/transport/guide_path.h"

namespace guidelight {

/// When to stop by itself; zero means no such limit.
struct RenderTargets {
  uint32_t passes = 0;
  double seconds = 0;
  double relative_error = 0;  // Film::estimated_relative_error

  bool operator==(const RenderTargets&) const = default;
};

/// Where a render stands between two passes: enough to go on with it later.
struct RenderProgress {
  std::shared_ptr<const Film> film;
  uint32_t next_pass = 0;
  double seconds = 0;
};

using SaveProgress = std::function<void(const RenderProgress&)>;

/// Shared so that it costs nothing to hand on; null for none.
using GuideList = std::shared_ptr<const std::vector<GuidePath>>;

/// What to render.
struct RenderJob {
  std::shared_ptr<const Scene> scene;
  std::string integrator = "path";
  std::shared_ptr<const IntegratorSettings> settings;  // null: the defaults for the scene
  uint64_t seed = 0;
  int threads = 0;  // 0: all processors
  Priority priority = Priority::Background;
  RenderTargets targets;
  std::optional<PixelRegion> region;
  /// For methods that can follow them; those that do not fit the scene are left out.
  GuideList guides;
  /// Bidirectional methods keep their techniques apart in these, of the scene's size. May be read
  /// when the job has finished, and by what RenderSession::save calls.
  std::shared_ptr<TechniqueImages> techniques;
  /// Show pictures of 1/8, 1/4, 1/2 of the size first, so that something is there at once.
  bool coarse_first = false;
  /// Receives the history of the pixels that somebody looks at, if the integrator records any.
  std::shared_ptr<PixelHistory> history;
  /// Goes on from here instead of from nothing; the film must have the scene's size.
  std::optional<RenderProgress> resume_from;
  /// Called on the render thread every `save_interval` seconds, and at the end, to save the
  /// progress. An exception it throws ends the job as failed.
  SaveProgress save;
  double save_interval = 60;
};

/// Renders in a thread of its own, at a priority below that of the caller's. All functions may be
/// called from any thread and return at once; commands are carried out in order. The destructor
/// stops and joins. A job that has reached a target rests, ready to go on.
class RenderSession {
 public:
  /// `published`, if given, is called from the render thread after each new snapshot, for instance
  /// to wake an event loop.
  explicit RenderSession(std::function<void()> published = {});
  ~RenderSession();
  RenderSession(const RenderSession&) = delete;
  RenderSession& operator=(const RenderSession&) = delete;

  /// Gives up what is being rendered and starts this. Returns the job number its snapshots will
  /// carry.
  uint64_t start(RenderJob job);
  /// Pauses between pieces of work; the pass goes on where it was when resumed. A job that is
  /// started while paused waits, after its first picture, until it is resumed.
  void pause();
  void resume();
  /// Gives up the pass that is being rendered; what was rendered is published.
  void stop();
  /// Replaces the targets of the job that was started last; one that had reached its own goes on.
  void set_targets(const RenderTargets& targets);
  /// From the next pass on the job that was started last follows these guides. What was rendered
  /// stays: guides change the noise, not the result.
  void set_guides(GuideList guides);
  /// From the next pass on the job that was started last keeps its techniques apart in these, of
  /// the scene's size; null for nowhere.
  void set_techniques(std::shared_ptr<TechniqueImages> techniques);
  /// From now on pictures come with photons of their last pass, at most `cap` of them; 0 for none,
  /// which costs nothing.
  void request_photons(size_t cap);
  /// Hands over the progress of the job that was started last, on the render thread, as soon as its
  /// pass is done or given up. If it is paused it goes on until then. Nothing is saved if the job
  /// fails, or is replaced before it has begun.
  void save(SaveProgress save);

  /// The latest picture; never null, without layers before the first.
  std::shared_ptr<const Snapshot> snapshot() const;

  /// Waits until the job has reached a target, failed or was stopped. For programs without an event
  /// loop.
  void wait() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace guidelight

#pragma once

#include <array>
#include <memory>
#include <string>

#include "renderer/image/film.h"
#include "renderer/integrators/integrator.h"

namespace guidelight {

enum class SessionState { Idle, Rendering, Paused, Finished, Failed };

/// When to stop by itself; zero means no such limit.
struct RenderTargets {
  uint32_t passes = 0;
  double seconds = 0;
  double relative_error = 0;  // Film::estimated_relative_error
};

/// What to render.
struct RenderJob {
  std::shared_ptr<const Scene> scene;
  std::string integrator = "path";
  std::shared_ptr<const IntegratorSettings> settings;  // null: the defaults for the scene
  uint64_t seed = 0;
  int threads = 0;  // 0: all
  RenderTargets targets;
  std::optional<PixelRegion> region;
  /// Show pictures of 1/8, 1/4, 1/2 of the size first, so that something is there at once.
  bool coarse_first = false;
};

/// An immutable copy of the state of a render.
struct Snapshot {
  uint64_t generation = 0;  // grows with every picture published
  uint64_t job = 0;         // grows with every restart: which command this picture answers
  SessionState state = SessionState::Idle;
  int full_width = 0;  // of the job; layers may be coarser
  int full_height = 0;
  bool coarse = false;
  std::array<Image, kLayerCount> layers;  // by Layer
  uint32_t passes = 0;
  double seconds = 0;  // spent rendering, pauses excluded
  uint64_t samples = 0;
  uint64_t rejected_samples = 0;
  double relative_error = 0;
  float progress = 0;       // towards the nearest target, 0..1; 0 without targets
  std::string error;        // why it failed, if it did

  const Image& layer(Layer which) const { return layers[static_cast<size_t>(which)]; }
};

/// Renders in a thread of its own. All functions may be called from any one thread and return at once;
/// commands are carried out in order. The destructor stops and joins.
class RenderSession {
 public:
  RenderSession();
  ~RenderSession();
  RenderSession(const RenderSession&) = delete;
  RenderSession& operator=(const RenderSession&) = delete;

  /// Gives up what is being rendered and starts this. Returns the job number its snapshots will carry.
  uint64_t start(RenderJob job);
  void pause();
  void resume();
  void stop();

  /// The latest picture; never null, empty layers before the first.
  std::shared_ptr<const Snapshot> snapshot() const;

  /// Called (from the render thread) after each publication, e.g. to wake an event loop. Set before start.
  void on_publish(std::function<void()> callback);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace guidelight

#include "renderer/session/render_session.h"

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "renderer/session/progressive_render.h"
#include "renderer/session/stopwatch.h"

namespace guidelight {

/// Everything below is guarded by one mutex that is only ever held for a moment. The render thread
/// holds no lock while it renders.
class RenderSession::Impl : private RenderObserver {
 public:
  explicit Impl(std::function<void()> published)
      : published_(std::move(published)), thread_([this] { run(); }) {}

  ~Impl() override {
    {
      const std::lock_guard lock(mutex_);
      quit_ = true;
      give_up_current_job();
    }
    thread_.join();
  }

  uint64_t start(RenderJob job) {
    const std::lock_guard lock(mutex_);
    next_ = std::move(job);
    give_up_current_job();
    return ++last_job_;
  }

  void stop() {
    const std::lock_guard lock(mutex_);
    next_.reset();
    give_up_current_job();
  }

  void set_targets(const RenderTargets& targets) {
    const std::lock_guard lock(mutex_);
    (next_ ? next_->targets : targets_) = targets;
    interrupt_rest();
  }

  void set_guides(GuideList guides) {
    const std::lock_guard lock(mutex_);
    (next_ ? next_->guides : guides_) = std::move(guides);
  }

  void set_techniques(std::shared_ptr<TechniqueImages> techniques) {
    const std::lock_guard lock(mutex_);
    (next_ ? next_->techniques : techniques_) = std::move(techniques);
  }

  void request_photons(size_t cap) { photons_wanted_ = cap; }

  void save(SaveProgress save) {
    const std::lock_guard lock(mutex_);
    save_requests_.push_back({last_job_, std::move(save)});
    apply_pause();
    interrupt_rest();
  }

  void set_paused(bool paused) {
    const std::lock_guard lock(mutex_);
    paused_ = paused;
    apply_pause();
    const SessionState state = snapshot_->state;
    if (state == SessionState::Rendering || state == SessionState::Paused) {
      Snapshot changed = *snapshot_;
      changed.state = paused ? SessionState::Paused : SessionState::Rendering;
      replace_snapshot(std::move(changed));
    }
  }

  std::shared_ptr<const Snapshot> snapshot() const {
    const std::lock_guard lock(mutex_);
    return snapshot_;
  }

  void wait() const {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return !next_ && (!control_ || (resting_ && !has_orders_)); });
  }

 private:
  void run() {
    while (auto job = next_job()) {
      try {
        render_progressively(*job, *control_, *this);
      } catch (const Stopped&) {
        // Given up on request; what there was has been published.
      } catch (const std::exception& error) {
        Snapshot failed;
        failed.state = SessionState::Failed;
        failed.error = error.what();
        publish(std::move(failed));
      }
    }
  }

  /// Waits for the next job; empty when the session ends.
  std::optional<RenderJob> next_job() {
    std::unique_lock lock(mutex_);
    control_.reset();
    changed_.notify_all();
    changed_.wait(lock, [&] { return quit_ || next_; });
    if (quit_) return std::nullopt;
    control_ = std::make_unique<WorkControl>();
    picture_shown_ = false;
    has_orders_ = false;
    watch_.restart();
    current_job_ = last_job_;
    std::erase_if(save_requests_, [&](const auto& request) { return request.job != current_job_; });
    targets_ = next_->targets;
    guides_ = next_->guides;
    techniques_ = next_->techniques;
    std::optional<RenderJob> job = std::move(next_);
    next_.reset();
    return job;
  }

  void publish(Snapshot snapshot) override {
    {
      const std::lock_guard lock(mutex_);
      snapshot.job = current_job_;
      if (!snapshot.coarse && !picture_shown_) {
        picture_shown_ = true;
        apply_pause();
      }
      if (paused_ && snapshot.state == SessionState::Rendering && !snapshot.coarse) {
        snapshot.state = SessionState::Paused;
      }
      replace_snapshot(std::move(snapshot));
    }
    if (published_) published_();
  }

  double seconds() const override {
    const std::lock_guard lock(mutex_);
    return watch_.seconds();
  }

  bool wants_unfinished() const override {
    const std::lock_guard lock(mutex_);
    return !next_ && !quit_;
  }

  RenderTargets targets() const override {
    const std::lock_guard lock(mutex_);
    return targets_;
  }

  GuideList guides() const override {
    const std::lock_guard lock(mutex_);
    return guides_;
  }

  std::shared_ptr<TechniqueImages> techniques() const override {
    const std::lock_guard lock(mutex_);
    return techniques_;
  }

  size_t photons_wanted() const override { return photons_wanted_; }

  std::vector<SaveProgress> take_save_requests() override {
    const std::lock_guard lock(mutex_);
    std::vector<SaveProgress> taken;
    std::erase_if(save_requests_, [&](auto& request) {
      if (request.job != current_job_) return false;
      taken.push_back(std::move(request.save));
      return true;
    });
    apply_pause();
    return taken;
  }

  void rest() override {
    std::unique_lock lock(mutex_);
    resting_ = true;
    apply_pause();
    changed_.notify_all();
    changed_.wait(lock, [&] { return has_orders_ || control_->stop_requested(); });
    resting_ = false;
    apply_pause();
    const bool has_orders = std::exchange(has_orders_, false);
    if (!has_orders) throw Stopped{};
  }

  // -- Called with the mutex held.

  void interrupt_rest() {
    has_orders_ = true;
    changed_.notify_all();
  }

  void give_up_current_job() {
    if (control_) control_->request_stop();
    changed_.notify_all();
  }

  /// A new job shows its first picture before it pauses, or a person who moves the camera while
  /// paused would see nothing. Progress is saved between passes, so the pass is rendered first.
  void apply_pause() {
    if (!control_) return;
    const bool pause = paused_ && picture_shown_ && save_requests_.empty();
    control_->set_paused(pause);
    watch_.set_paused(pause || resting_);
  }

  void replace_snapshot(Snapshot snapshot) {
    snapshot.generation = ++generation_;
    snapshot_ = std::make_shared<const Snapshot>(std::move(snapshot));
  }

  const std::function<void()> published_;
  mutable std::mutex mutex_;
  mutable std::condition_variable changed_;
  std::atomic<size_t> photons_wanted_ = 0;
  bool quit_ = false;
  bool paused_ = false;
  bool picture_shown_ = false;                   // of the current job, at full size
  bool resting_ = false;                         // the current job has reached a target
  bool has_orders_ = false;                      // something was asked for that ends the rest
  RenderTargets targets_;                        // of the current job
  GuideList guides_;                             // of the current job
  std::shared_ptr<TechniqueImages> techniques_;  // of the current job
  struct SaveRequest {
    uint64_t job;
    SaveProgress save;
  };
  std::vector<SaveRequest> save_requests_;
  std::optional<RenderJob> next_;         // waits for the thread
  std::unique_ptr<WorkControl> control_;  // of the current job; null between jobs
  uint64_t last_job_ = 0;                 // number given out by start()
  uint64_t current_job_ = 0;
  uint64_t generation_ = 0;
  Stopwatch watch_;
  std::shared_ptr<const Snapshot> snapshot_ = std::make_shared<const Snapshot>();
  std::thread thread_;  // last: starts when everything else is ready
};

RenderSession::RenderSession(std::function<void()> published)
    : impl_(std::make_unique<Impl>(std::move(published))) {}
RenderSession::~RenderSession() = default;

uint64_t RenderSession::start(RenderJob job) { return impl_->start(std::move(job)); }
void RenderSession::pause() { impl_->set_paused(true); }
void RenderSession::resume() { impl_->set_paused(false); }
void RenderSession::stop() { impl_->stop(); }
void RenderSession::set_targets(const RenderTargets& targets) { impl_->set_targets(targets); }
void RenderSession::set_guides(GuideList guides) { impl_->set_guides(std::move(guides)); }
void RenderSession::set_techniques(std::shared_ptr<TechniqueImages> techniques) {
  impl_->set_techniques(std::move(techniques));
}
void RenderSession::request_photons(size_t cap) { impl_->request_photons(cap); }
void RenderSession::save(SaveProgress save) { impl_->save(std::move(save)); }
std::shared_ptr<const Snapshot> RenderSession::snapshot() const { return impl_->snapshot(); }
void RenderSession::wait() const { impl_->wait(); }

}  // namespace guidelight

#include "ui/checkpoint_saver.h"

#include <utility>

namespace guidelight {

CheckpointSaver::CheckpointSaver(Document& document, std::shared_ptr<UiQueue> queue,
                                 std::string folder)
    : document_(document), queue_(std::move(queue)), files_(std::move(folder)) {}

void CheckpointSaver::save(const std::string& path) {
  // On the render thread; `this` is only used on the UI thread, while it runs the queue.
  const auto report = [this, path, queue = queue_](const std::string& problem) {
    queue->post([this, path, problem] {
      if (problem.empty()) {
        document_.messages().note("Saved the progress to " + path);
      } else {
        document_.messages().error(problem);
      }
    });
  };
  if (!document_.save_checkpoint(path, report)) {
    document_.messages().warning("There is no render to save yet.");
  }
}

void CheckpointSaver::update(Clock::time_point now) {
  const Snapshot& status = document_.status();
  if (status.job != job_) {
    job_ = status.job;
    path_.clear();
    saved_at_ = now;
    saved_passes_ = 0;
  }
  if (autosave_minutes_ <= 0 || !document_.has_scene()) return;
  // A render that is paused, or has finished, renders one pass to be saved.
  const uint32_t own_passes = status.state == SessionState::Rendering ? 0 : 1;
  if (status.passes <= saved_passes_ + own_passes) return;
  const bool due = now - saved_at_ >= std::chrono::minutes(autosave_minutes_);
  if (!due && status.state != SessionState::Finished) return;
  if (path_.empty()) path_ = files_.next(document_.title(), "checkpoint");
  saved_at_ = now;
  saved_passes_ = status.passes;
  save(path_);
}

}  // namespace guidelight

#pragma once

#include <memory>
#include <string>

#include "ui/document.h"
#include "ui/numbered_files.h"
#include "ui/ui_queue.h"

namespace guidelight {

/// Saves checkpoints of the document's render, on request and every so often. Each says in the
/// messages where it was written, or why it could not be.
class CheckpointSaver {
 public:
  using Clock = Document::Clock;

  /// Automatic ones go to `folder`.
  CheckpointSaver(Document& document, std::shared_ptr<UiQueue> queue, std::string folder);

  /// Writes over what is at `path`.
  void save(const std::string& path);
  /// A new name beside the automatic ones.
  std::string suggested_path() const { return files_.suggest(document_.title(), "checkpoint"); }

  /// Minutes of the clock between automatic checkpoints of a render; 0: none.
  int& autosave_minutes() { return autosave_minutes_; }
  /// Saves if it is time, or if the render has just reached its target; to be called once per
  /// frame. A render overwrites its own last automatic checkpoint and nobody else's.
  void update(Clock::time_point now);

 private:
  Document& document_;
  std::shared_ptr<UiQueue> queue_;
  NumberedFiles files_;
  int autosave_minutes_ = 0;

  // Of the automatic ones:
  uint64_t job_ = 0;
  std::string path_;            // of this job; empty before its first
  Clock::time_point saved_at_;  // or when the job came
  uint32_t saved_passes_ = 0;
};

}  // namespace guidelight

#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "ui/background_thread.h"
#include "ui/document.h"
#include "ui/ui_queue.h"

namespace guidelight {

/// Keeps the guides of the open scene in the file beside it: a moment after each change, and at the
/// latest when the scene or the program is closed.
class GuideSaver {
 public:
  using Clock = Document::Clock;

  GuideSaver(Document& document, UiQueue& queue) : document_(document), queue_(queue) {}
  ~GuideSaver() { flush(); }

  /// To be called once per frame.
  void update(Clock::time_point now);
  /// Whether a change waits to be saved; it is when update() is called later.
  bool pending() const { return list_ != saved_; }
  const std::string& path() const { return path_; }

 private:
  void flush();
  void write(const std::string& path, const GuideList& list, bool is_unreadable);

  Document& document_;
  UiQueue& queue_;
  std::string path_;  // empty before the first scene
  uint64_t scene_ = 0;
  GuideList list_;
  GuideList saved_;
  bool is_unreadable_ = false;  // the file; it is put aside, not overwritten
  Clock::time_point changed_at_;
  std::filesystem::file_time_type known_;  // of the file when it was last ours; used by the writer
  BackgroundThread writer_;                // last: it finishes before the rest goes
};

}  // namespace guidelight

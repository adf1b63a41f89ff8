#pragma once

#include <filesystem>
#include <functional>
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
  ~GuideSaver();

  /// To be called once per frame.
  void update(Clock::time_point now);
  /// Whether a change waits to be saved; it is when update() is called later. What could not be
  /// saved is tried again with the next change, and at the end.
  bool pending() const { return list_ != tried_; }
  const std::string& path() const { return path_; }

 private:
  using Report = std::function<void(const std::string&)>;

  void flush(Report failed);
  void save(const std::string& path, const GuideList& list, const Report& failed);
  void set_aside(const std::string& path);

  Document& document_;
  UiQueue& queue_;
  std::string path_;  // empty before the first scene
  uint64_t scene_ = 0;
  GuideList list_;
  GuideList tried_;  // given to the writer last
  GuideList saved_;  // as far as the writer has said
  Clock::time_point changed_at_;
  struct {
    GuideList list;                         // that is in the file
    std::filesystem::file_time_type known;  // of the file when it was last ours
    bool is_unreadable = false;             // it is put aside, not overwritten
  } file_;                                  // used by the writer alone
  BackgroundThread writer_;                 // last: it finishes before the rest goes
};

}  // namespace guidelight

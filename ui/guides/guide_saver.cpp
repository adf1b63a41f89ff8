#include "ui/guides/guide_saver.h"

#include <filesystem>
#include <utility>

#include "renderer/io/guide_file.h"
#include "ui/numbered_files.h"

namespace guidelight {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::milliseconds kCalm{400};  // without a change, before it is saved

fs::file_time_type time_of(const std::string& path) {
  std::error_code absent;
  return fs::last_write_time(path, absent);
}

}  // namespace

void GuideSaver::update(Clock::time_point now) {
  if (!document_.has_scene()) return;
  if (document_.openings() != scene_) {
    const GuideList unsaved = pending() ? list_ : nullptr;
    const std::string before = path_;
    flush();
    scene_ = document_.openings();
    path_ = guide_file_beside(document_.opened().path);
    is_unreadable_ = !document_.opened().guide_problem.empty();
    list_ = saved_ = document_.guides_as_opened();
    writer_.run([this, path = path_] { known_ = time_of(path); });
    // What was not saved yet was not in the file when the scene was read again.
    if (unsaved && path_ == before) document_.edit_guides(*unsaved, "guides before the reload");
  }
  if (document_.guides() != list_) {
    list_ = document_.guides();
    changed_at_ = now;
  }
  if (pending() && now - changed_at_ >= kCalm) flush();
}

void GuideSaver::flush() {
  if (!pending()) return;
  saved_ = list_;
  const bool is_unreadable = std::exchange(is_unreadable_, false);
  writer_.run([this, path = path_, list = list_, is_unreadable] {
    try {
      write(path, list, is_unreadable);
    } catch (const std::exception& error) {
      queue_.post([this, text = std::string(error.what())] { document_.messages().error(text); });
    }
  });
}

/// On the writer's thread. A file that is not as we left it is somebody's work.
void GuideSaver::write(const std::string& path, const GuideList& list, bool is_unreadable) {
  const bool is_changed = fs::exists(path) && time_of(path) != known_;
  if (is_unreadable || is_changed) {
    const fs::path file = path;
    const std::string aside =
        NumberedFiles(file.parent_path().string())
            .next(file.filename().string(), is_unreadable ? "unreadable" : "other");
    fs::rename(path, aside);
    const std::string reason = is_unreadable ? "could not be read" : "was changed from elsewhere";
    queue_.post([this, text = path + " " + reason + "; it is kept as " + aside] {
      document_.messages().warning(text);
    });
  }
  write_guides(path, *list);
  known_ = time_of(path);
}

}  // namespace guidelight

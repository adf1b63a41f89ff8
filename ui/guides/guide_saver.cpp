#include "ui/guides/guide_saver.h"

#include <cstdio>
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

/// Nobody reads the messages any more.
GuideSaver::~GuideSaver() {
  flush([](const std::string& reason) { std::fputs((reason + "\n").c_str(), stderr); });
}

void GuideSaver::update(Clock::time_point now) {
  if (!document_.has_scene()) return;
  const Report say = [this](const std::string& reason) {
    queue_.post([this, reason] { document_.messages().error(reason); });
  };
  if (document_.openings() != scene_) {
    const GuideList unsaved = list_ != saved_ ? list_ : nullptr;
    const std::string before = path_;
    flush(say);
    scene_ = document_.openings();
    path_ = guide_file_beside(document_.opened().path);
    list_ = tried_ = saved_ = document_.guides_as_opened();
    const bool is_unreadable = !document_.opened().guide_problem.empty();
    writer_.run([this, path = path_, list = list_, is_unreadable] {
      file_ = {list, time_of(path), is_unreadable};
    });
    // What was not saved yet was not in the file when the scene was read again.
    if (unsaved && path_ == before) document_.edit_guides(*unsaved, "guides before the reload");
  }
  if (document_.guides() != list_) {
    list_ = document_.guides();
    changed_at_ = now;
  }
  if (pending() && now - changed_at_ >= kCalm) flush(say);
}

void GuideSaver::flush(Report failed) {
  tried_ = list_;
  writer_.run([this, path = path_, list = list_, failed = std::move(failed)] {
    if (list != file_.list) save(path, list, failed);
  });
}

/// On the writer's thread, like set_aside().
void GuideSaver::save(const std::string& path, const GuideList& list, const Report& failed) {
  try {
    set_aside(path);
    write_guides(path, *list);
    file_ = {list, time_of(path), false};
    queue_.post([this, path, list] {
      if (path == path_) saved_ = list;
    });
  } catch (const std::exception& error) {
    failed(error.what());
  }
}

/// A file that is not as we left it is somebody's work.
void GuideSaver::set_aside(const std::string& path) {
  const bool is_changed = fs::exists(path) && time_of(path) != file_.known;
  if (!file_.is_unreadable && !is_changed) return;
  const fs::path file = path;
  const std::string aside =
      NumberedFiles(file.parent_path().string())
          .next(file.filename().string(), file_.is_unreadable ? "unreadable" : "other");
  fs::rename(path, aside);
  const std::string reason =
      file_.is_unreadable ? "could not be read" : "was changed from elsewhere";
  file_.is_unreadable = false;
  queue_.post([this, text = path + " " + reason + "; it is kept as " + aside] {
    document_.messages().warning(text);
  });
}

}  // namespace guidelight

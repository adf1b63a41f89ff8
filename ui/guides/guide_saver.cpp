#include "ui/guides/guide_saver.h"

#include <filesystem>
#include <utility>

#include "renderer/io/guide_file.h"

namespace guidelight {
namespace {

constexpr std::chrono::milliseconds kCalm{400};  // without a change, before it is saved

}  // namespace

void GuideSaver::update(Clock::time_point now) {
  if (!document_.has_scene()) return;
  if (document_.openings() != scene_) {
    flush();
    scene_ = document_.openings();
    path_ = guide_file_beside(document_.opened().path);
    keep_unreadable_ = !document_.opened().guide_problem.empty();
    list_ = saved_ = document_.guides_as_opened();
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
  const bool keep = std::exchange(keep_unreadable_, false);
  writer_.run([this, path = path_, list = list_, keep] {
    try {
      if (keep) std::filesystem::rename(path, path + ".unreadable");
      write_guides(path, *list);
    } catch (const std::exception& error) {
      queue_.post([this, text = std::string(error.what())] { document_.messages().error(text); });
    }
  });
}

}  // namespace guidelight

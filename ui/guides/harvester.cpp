#include "ui/guides/harvester.h"

namespace guidelight {
namespace {

constexpr int kSamples = 60'000;
constexpr size_t kPathsShown = 10;

}  // namespace

void Harvester::update(bool wanted) {
  Subject subject;
  if (wanted && document_.has_scene()) {
    subject = {document_.openings(), document_.camera().to_world(), document_.view().harvested()};
  }
  if (subject == subject_) return;
  stop_ = busy_;
  if (busy_) return;
  subject_ = subject;
  document_.harvest() = {subject.region, {}, {}, subject.region.has_value()};
  if (!subject.region) return;
  busy_ = true;
  const auto search = [this, subject, scene = document_.current_scene()] {
    auto paths = harvest(*scene, *subject.region, kSamples, kPathsShown, stop_);
    queue_.post([this, subject, paths = std::move(paths)] {
      busy_ = false;
      if (stop_.exchange(false)) {
        subject_ = {};  // it is begun again if it is still wanted
        return;
      }
      if (subject == subject_) document_.harvest() = {subject.region, paths, {}, false, true};
    });
  };
  worker_.run(search, [this](const std::string& reason) {
    queue_.post([this, text = "Light paths cannot be searched for: " + reason] {
      busy_ = stop_ = false;
      document_.harvest().searching = false;
      document_.messages().error(text);
    });
  });
}

}  // namespace guidelight

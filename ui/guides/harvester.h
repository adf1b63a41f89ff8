#pragma once

#include <atomic>

#include "ui/background_thread.h"
#include "ui/document.h"
#include "ui/ui_queue.h"

namespace guidelight {

/// Finds the light paths of the part of the picture that was picked in the background and hands
/// them to the document.
class Harvester {
 public:
  Harvester(Document& document, UiQueue& queue) : document_(document), queue_(queue) {}
  ~Harvester() { stop_ = true; }

  /// To be called once per frame; `wanted`: somebody wants to see the paths.
  void update(bool wanted);

 private:
  struct Subject {  // what the paths are of
    uint64_t scene = 0;
    Mat4 camera{0.0f};
    std::optional<PixelRegion> region;
    bool operator==(const Subject&) const = default;
  };

  Document& document_;
  UiQueue& queue_;
  Subject subject_;
  bool busy_ = false;
  std::atomic<bool> stop_ = false;
  BackgroundThread worker_;  // last: it finishes before the rest goes
};

}  // namespace guidelight

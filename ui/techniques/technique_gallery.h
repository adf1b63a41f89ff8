#pragma once

#include "ui/background_thread.h"
#include "ui/document.h"
#include "ui/ui_queue.h"

namespace guidelight {

/// Pictures of all techniques that brought anything, ready for the screen.
struct TechniquePictures {
  struct Thumbnail {
    TechniqueImages::Technique technique;
    Color mean;  // linear, weighted or raw as asked for
  };
  std::vector<Thumbnail> thumbnails;
  DisplayImage stack;   // of the thumbnails, one below the other
  float luminance = 0;  // of all, as weighted
  std::optional<TechniqueImages::Technique> enlarged;
  DisplayImage large;  // of the enlarged one
};

/// Makes pictures of the techniques that are recorded while somebody looks at them. The render
/// hands them over between two passes, at most once a second; tone mapping is done in the
/// background.
class TechniqueGallery {
 public:
  TechniqueGallery(Document& document, std::shared_ptr<UiQueue> queue)
      : document_(document), queue_(std::move(queue)) {}

  /// To be called once per frame.
  void update(Document::Clock::time_point now);
  /// Whether it will ask the render for something in a moment.
  bool pending() const { return pending_; }
  /// The latest pictures; null before the first.
  const std::shared_ptr<const TechniquePictures>& pictures() const { return pictures_; }

 private:
  /// What the render has handed over: linear.
  struct Kept {
    std::map<TechniqueImages::Technique, TechniqueImages::Pair> thumbnails;
    std::optional<TechniqueImages::Technique> enlarged;
    TechniqueImages::Pair large;
  };
  struct Look {
    std::shared_ptr<const Kept> kept;
    bool weighted = true;
    DisplaySettings display;
    bool operator==(const Look&) const = default;
  };

  bool needs_more() const;
  void ask(Document::Clock::time_point now);
  void develop();
  static std::shared_ptr<const TechniquePictures> develop(const Look& look);

  Document& document_;
  std::shared_ptr<UiQueue> queue_;
  std::shared_ptr<TechniqueImages> images_;  // that kept_ is of, or will be
  std::shared_ptr<const Kept> kept_;         // null before the first
  bool asked_ = false;
  bool pending_ = false;
  Document::Clock::time_point asked_at_;
  uint64_t asked_generation_ = 0;  // snapshot
  Look look_;                      // what pictures_ are, or will be
  std::shared_ptr<const TechniquePictures> pictures_;
  BackgroundThread worker_;  // last: it finishes before the rest goes
};

}  // namespace guidelight

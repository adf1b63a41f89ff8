#include "ui/techniques/technique_gallery.h"

#include <algorithm>

#include "renderer/image/metrics.h"

namespace guidelight {
namespace {

constexpr std::chrono::milliseconds kBetweenRequests{1000};
constexpr std::chrono::milliseconds kBetweenFirstRequests{50};  // while there is nothing to show
constexpr int kThumbnail = 192;                                 // longest side [pixels]

}  // namespace

void TechniqueGallery::update(Document::Clock::time_point now) {
  TechniqueView& view = document_.technique_view();
  if (images_ != document_.techniques()) {
    images_ = document_.techniques();
    kept_ = nullptr;
    asked_ = false;
  }
  if (!images_) {
    view.shown = false;
    view.enlarged.reset();
    pictures_ = nullptr;
  }
  pending_ = false;
  if (!view.shown) return;
  if (needs_more()) {
    const bool at_once = kept_ && kept_->enlarged != view.enlarged;
    const auto wait = kept_ ? kBetweenRequests : kBetweenFirstRequests;
    if (at_once || now - asked_at_ > wait) ask(now);
    pending_ = !asked_;
  }
  develop();
}

/// A paused render would go on for each request, so it is asked only for what nobody has seen.
bool TechniqueGallery::needs_more() const {
  if (asked_) return false;
  if (!kept_ || kept_->enlarged != document_.technique_view().enlarged) return true;
  return document_.status().generation != asked_generation_ && !document_.paused();
}

void TechniqueGallery::ask(Document::Clock::time_point now) {
  asked_ = true;
  asked_at_ = now;
  asked_generation_ = document_.status().generation;
  document_.between_passes(
      [this, queue = queue_, images = images_, enlarged = document_.technique_view().enlarged] {
        // `this` is only used on the UI thread, which drops what is posted once the gallery is
        // gone.
        std::shared_ptr<Kept> kept;
        if (!images->empty()) {
          const int side = std::max(images->width(), images->height());
          kept = std::make_shared<Kept>(
              Kept{images->develop((side + kThumbnail - 1) / kThumbnail), enlarged, {}});
          if (enlarged) kept->large = images->develop(*enlarged);
        }
        queue->post([this, images, kept] {
          if (images != images_) return;
          asked_ = false;
          if (kept) kept_ = kept;
        });
      });
}

void TechniqueGallery::develop() {
  if (!kept_) return;
  const Look wanted{kept_, document_.technique_view().weighted, document_.view().of_radiance()};
  if (wanted == look_) return;
  look_ = wanted;
  const auto develop_all = [this, wanted, queue = queue_] {
    queue->post([this, wanted, pictures = develop(wanted)] {
      if (wanted == look_) pictures_ = pictures;
    });
  };
  worker_.run(develop_all, [this, queue = queue_](const std::string& reason) {
    queue->post([this, text = "The techniques cannot be shown: " + reason] {
      document_.messages().error(text);
    });
  });
}

std::shared_ptr<const TechniquePictures> TechniqueGallery::develop(const Look& look) {
  auto pictures = std::make_shared<TechniquePictures>();
  const auto chosen = [&](const TechniqueImages::Pair& pair) -> const Image& {
    return look.weighted ? pair.weighted : pair.raw;
  };
  for (const auto& [technique, pair] : look.kept->thumbnails) {
    const Image& image = chosen(pair);
    pictures->thumbnails.push_back({technique, mean_color(image)});
    pictures->luminance += luminance(mean_color(pair.weighted));
    DisplayImage thumbnail;
    display_image(image, look.display, thumbnail);
    DisplayImage& stack = pictures->stack;
    stack.width = thumbnail.width;
    stack.height += thumbnail.height;
    stack.rgba.insert(stack.rgba.end(), thumbnail.rgba.begin(), thumbnail.rgba.end());
  }
  pictures->enlarged = look.kept->enlarged;
  if (pictures->enlarged) display_image(chosen(look.kept->large), look.display, pictures->large);
  return pictures;
}

}  // namespace guidelight

#pragma once

#include <functional>
#include <memory>

#include "ui/background_thread.h"
#include "ui/document.h"
#include "ui/photons/density_mesh.h"
#include "ui/ui_queue.h"

namespace guidelight {

/// What is known about the photons around any place, found out in the background.
struct PhotonKnowledge {
  PhotonSearch search;
  std::optional<DensityMap> density;  // if somebody wants to see it
};

/// Prepares the searches and density maps of the photons shown, one after another: of the newest
/// photons when the last are done.
class PhotonMapper {
 public:
  /// `found` is called on the UI thread.
  PhotonMapper(UiQueue& queue, Messages& messages,
               std::function<void(std::shared_ptr<const PhotonKnowledge>)> found)
      : queue_(queue), messages_(messages), found_(std::move(found)) {}

  /// Another scene: `mesh` are its triangles.
  void show(std::shared_ptr<const DisplayMesh> mesh, float scene_radius);
  /// To be called once per frame; null if no photons are shown.
  void update(const std::shared_ptr<const PhotonCloud>& cloud, bool density_wanted,
              Document::Clock::time_point now);
  /// Whether update() has something to do that must wait a moment.
  bool pending() const { return pending_; }

 private:
  UiQueue& queue_;
  Messages& messages_;
  std::function<void(std::shared_ptr<const PhotonKnowledge>)> found_;
  std::shared_ptr<const DisplayMesh> surfaces_;  // finely divided; null before they are wanted
  std::shared_ptr<const DisplayMesh> mesh_;
  float scene_radius_ = 0;
  std::shared_ptr<const PhotonCloud> known_;
  bool density_known_ = false;
  Document::Clock::time_point begun_;
  bool pending_ = false;
  bool busy_ = false;
  BackgroundThread worker_;  // last: it finishes before the rest goes
};

}  // namespace guidelight

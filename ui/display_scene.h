#pragma once

#include <memory>

#include "ui/background_thread.h"
#include "ui/document.h"
#include "ui/gl/mesh_raster.h"
#include "ui/photons/photon_colors.h"
#include "ui/ui_queue.h"

namespace guidelight {

/// What OpenGL draws of a document in any view: the scene's triangles and the photons.
class DisplayScene {
 public:
  explicit DisplayScene(UiQueue& queue) : queue_(queue) {}

  /// Prepares the triangles of another scene in the background.
  void show(std::shared_ptr<const Scene> scene);
  /// Takes over what has changed; to be called once per frame.
  void update(const Document& document);
  /// Grows whenever something has changed that can be seen.
  uint64_t version() const { return version_; }

  /// Into the current target; nothing before the triangles are ready.
  void draw_mesh(const Mat4& clip_from_world, const MeshRaster::Look& look) const;
  void draw_photons(const Mat4& clip_from_world, const PointRaster::Look& look) const;
  bool has_photons() const { return points_ && !points_->empty(); }

  /// Of the photons shown.
  const PowerHistogram& powers() const { return powers_; }

 private:
  void take_photons(const PhotonView& view, std::shared_ptr<const PhotonCloud> cloud);

  UiQueue& queue_;
  uint64_t version_ = 0;
  uint64_t request_ = 0;  // the scene shown last wins
  std::unique_ptr<MeshRaster> mesh_;
  std::unique_ptr<PointRaster> points_;
  std::shared_ptr<const PhotonCloud> cloud_;
  PhotonColoring coloring_ = PhotonColoring::Power;
  float point_size_ = 0;
  PowerHistogram powers_;
  BackgroundThread tessellator_;  // last: it finishes before the rest goes
};

}  // namespace guidelight

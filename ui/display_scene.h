#pragma once

#include <imgui.h>

#include <memory>

#include "ui/background_thread.h"
#include "ui/document.h"
#include "ui/gl/mesh_raster.h"
#include "ui/photons/photon_colors.h"
#include "ui/photons/photon_mapper.h"
#include "ui/ui_queue.h"

namespace guidelight {

/// What OpenGL draws of a document in any view: the scene's triangles and the photons.
class DisplayScene {
 public:
  /// Says in the messages what cannot be drawn as it is.
  DisplayScene(UiQueue& queue, Messages& messages);

  /// Prepares the triangles of another scene in the background.
  void show(std::shared_ptr<const Scene> scene);
  /// Takes over what has changed; to be called once per frame.
  void update(const Document& document, Document::Clock::time_point now);
  bool pending() const { return mapper_.pending(); }
  /// Grows whenever something has changed that can be seen.
  uint64_t version() const { return version_; }

  /// Into the current target; nothing before the triangles are ready.
  void draw_mesh(const Mat4& clip_from_world, const MeshRaster::Look& look) const;
  void draw_photons(const Mat4& clip_from_world, const PointRaster::Look& look) const;
  void draw_density(const Mat4& clip_from_world, const MeshRaster::Look& look) const;
  /// What the colours of the density mean, in the lower right corner of a view; nothing without.
  void draw_density_scale(ImDrawList& list, Vec2 corner) const;
  bool has_points() const { return points_ && !points_->empty(); }
  bool has_density() const { return density_ && !density_->empty(); }

  /// Of the photons shown.
  const PowerHistogram& powers() const { return powers_; }
  const std::vector<GuideShare>& guide_shares() const { return guide_shares_; }
  /// What is known about the photons shown; null before it is.
  const std::shared_ptr<const PhotonKnowledge>& photons() const { return photons_; }

 private:
  void take_mesh(const std::shared_ptr<const DisplayMesh>& mesh, float radius);
  void take_points(const Document& document, std::shared_ptr<const PhotonCloud> cloud);
  void take_knowledge(std::shared_ptr<const PhotonKnowledge> photons);

  UiQueue& queue_;
  Messages& messages_;
  uint64_t version_ = 0;
  uint64_t request_ = 0;  // the scene shown last wins
  std::unique_ptr<MeshRaster> mesh_;
  std::unique_ptr<PointRaster> points_;
  std::shared_ptr<const PhotonCloud> cloud_;
  PhotonView view_;
  GuideList guides_;  // in whose colours the points are
  PowerHistogram powers_;
  std::vector<GuideShare> guide_shares_;
  std::shared_ptr<const PhotonKnowledge> photons_;
  std::unique_ptr<MeshRaster> density_;
  PhotonMapper mapper_;
  BackgroundThread tessellator_;  // last: it finishes before the rest goes
};

}  // namespace guidelight

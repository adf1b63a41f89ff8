#include "ui/display_scene.h"

namespace guidelight {

void DisplayScene::show(std::shared_ptr<const Scene> scene) {
  const uint64_t request = ++request_;
  tessellator_.run([this, scene = std::move(scene), request] {
    auto mesh = std::make_shared<DisplayMesh>(make_display_mesh(scene->description()));
    queue_.post([this, mesh, request] {
      if (request != request_) return;
      if (!mesh_) mesh_ = std::make_unique<MeshRaster>();
      mesh_->upload(*mesh);
      ++version_;
    });
  });
}

void DisplayScene::update(const Document& document) {
  const PhotonView& view = document.photon_view();
  const auto cloud = view.shown && document.picture() ? document.picture()->photons : nullptr;
  take_photons(view, cloud);
}

void DisplayScene::take_photons(const PhotonView& view, std::shared_ptr<const PhotonCloud> cloud) {
  if (view.point_size != point_size_) ++version_;
  point_size_ = view.point_size;
  if (cloud == cloud_ && view.coloring == coloring_) return;
  cloud_ = std::move(cloud);
  coloring_ = view.coloring;
  powers_ = cloud_ ? power_histogram(*cloud_) : PowerHistogram{};
  if (!points_) points_ = std::make_unique<PointRaster>();
  points_->upload(cloud_ ? color_photons(*cloud_, coloring_, powers_)
                         : std::vector<PointRaster::Vertex>{});
  ++version_;
}

void DisplayScene::draw_mesh(const Mat4& clip_from_world, const MeshRaster::Look& look) const {
  if (mesh_) mesh_->draw(clip_from_world, look);
}

void DisplayScene::draw_photons(const Mat4& clip_from_world, const PointRaster::Look& look) const {
  if (!has_photons()) return;
  PointRaster::Look sized = look;
  sized.size = point_size_;
  points_->draw(clip_from_world, sized);
}

}  // namespace guidelight

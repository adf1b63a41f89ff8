#include "ui/display_scene.h"

#include <fmt/format.h>

#include "ui/legend.h"

namespace guidelight {

DisplayScene::DisplayScene(UiQueue& queue, Messages& messages)
    : queue_(queue),
      messages_(messages),
      mapper_(queue, messages, [this](std::shared_ptr<const PhotonKnowledge> photons) {
        take_knowledge(std::move(photons));
      }) {}

void DisplayScene::show(std::shared_ptr<const Scene> scene) {
  const uint64_t request = ++request_;
  const auto tessellate = [this, scene = std::move(scene), request] {
    auto mesh = std::make_shared<DisplayMesh>(make_display_mesh(scene->description()));
    queue_.post([this, mesh, request, radius = scene->bounds().radius()] {
      if (request == request_) take_mesh(mesh, radius);
    });
  };
  tessellator_.run(tessellate, [this](const std::string& reason) {
    queue_.post([this, text = "The scene cannot be shown in the scout view: " + reason] {
      messages_.error(text);
    });
  });
}

void DisplayScene::take_mesh(const std::shared_ptr<const DisplayMesh>& mesh, float radius) {
  if (!mesh_) mesh_ = std::make_unique<MeshRaster>();
  mesh_->upload(*mesh);
  mapper_.show(mesh, radius);
  take_knowledge(nullptr);
  if (mesh->boxes == 0) return;
  messages_.note(fmt::format(
      "The scout view shows {} instances as boxes: their triangles are too many to be drawn.",
      mesh->boxes));
}

void DisplayScene::update(const Document& document, Document::Clock::time_point now) {
  const PhotonView& view = document.photon_view();
  const auto cloud = view.shown && document.picture() ? document.picture()->photons : nullptr;
  take_points(document, cloud);
  mapper_.update(cloud, view.density, now);
}

void DisplayScene::take_points(const Document& document, std::shared_ptr<const PhotonCloud> cloud) {
  const PhotonView& view = document.photon_view();
  const bool recolored = view.coloring == PhotonColoring::Guide && document.guides() != guides_;
  if (cloud == cloud_ && view == view_ && !recolored) return;
  const bool is_new = cloud != cloud_;
  cloud_ = std::move(cloud);
  view_ = view;
  guides_ = document.guides();
  if (is_new) {
    powers_ = cloud_ ? power_histogram(*cloud_) : PowerHistogram{};
    guide_shares_ = cloud_ ? shares_of_guides(*cloud_) : std::vector<GuideShare>{};
  }
  if (!points_) points_ = std::make_unique<PointRaster>();
  points_->upload(cloud_ && view.points ? color_photons(*cloud_, view.coloring, powers_, *guides_)
                                        : std::vector<PointRaster::Vertex>{});
  ++version_;
}

void DisplayScene::take_knowledge(std::shared_ptr<const PhotonKnowledge> photons) {
  photons_ = std::move(photons);
  if (!density_) density_ = std::make_unique<MeshRaster>();
  density_->upload(photons_ && photons_->density ? photons_->density->mesh : DisplayMesh{});
  ++version_;
}

void DisplayScene::draw_mesh(const Mat4& clip_from_world, const MeshRaster::Look& look) const {
  if (mesh_) mesh_->draw(clip_from_world, look);
}

void DisplayScene::draw_density(const Mat4& clip_from_world, const MeshRaster::Look& look) const {
  if (has_density()) density_->draw(clip_from_world, look);
}

void DisplayScene::draw_density_scale(ImDrawList& list, Vec2 corner) const {
  if (!photons_ || !photons_->density || photons_->density->high == 0) return;
  const DensityMap& density = *photons_->density;
  draw_color_scale(list, corner, {kDensityColors, density.low, density.high, "photons/m²"});
}

void DisplayScene::draw_photons(const Mat4& clip_from_world, const PointRaster::Look& look) const {
  if (!has_points()) return;
  PointRaster::Look sized = look;
  sized.size = view_.point_size;
  points_->draw(clip_from_world, sized);
}

}  // namespace guidelight

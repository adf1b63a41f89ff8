#include "ui/photons/photon_mapper.h"

namespace guidelight {
namespace {

constexpr float kFarthestPhoton = 0.06f;  // that photons are searched for, of the scene's radius
constexpr size_t kTriangles = 40'000;     // that show the density, about
constexpr std::chrono::seconds kRest{1};  // between maps while a render goes on

}  // namespace

void PhotonMapper::show(std::shared_ptr<const DisplayMesh> mesh, float scene_radius) {
  mesh_ = std::move(mesh);
  scene_radius_ = scene_radius;
  surfaces_ = nullptr;
  known_ = nullptr;
}

void PhotonMapper::update(const std::shared_ptr<const PhotonCloud>& cloud, bool density_wanted,
                          Document::Clock::time_point now) {
  const bool only_newer = density_wanted == density_known_ && cloud && known_;
  pending_ = false;
  if (busy_ || !mesh_ || (cloud == known_ && density_wanted == density_known_)) return;
  pending_ = only_newer && now - begun_ < kRest;
  if (pending_) return;
  known_ = cloud;
  density_known_ = density_wanted;
  if (!cloud || cloud->points.empty()) {
    found_(nullptr);
    return;
  }
  busy_ = true;
  begun_ = now;
  const auto map = [this, cloud, density_wanted, mesh = mesh_, surfaces = surfaces_,
                    reach = kFarthestPhoton * scene_radius_]() mutable {
    Parallel alone(1, nullptr, Priority::Background);
    auto knowledge = std::make_shared<PhotonKnowledge>(
        PhotonKnowledge{PhotonSearch(*cloud, reach, alone), std::nullopt});
    if (density_wanted) {
      if (!surfaces) surfaces = std::make_shared<DisplayMesh>(subdivided(*mesh, kTriangles));
      knowledge->density = make_density_map(*surfaces, knowledge->search);
    }
    queue_.post([this, cloud, mesh, surfaces, knowledge] {
      busy_ = false;
      if (mesh != mesh_) return;  // of another scene by now
      surfaces_ = surfaces;
      if (cloud == known_) found_(knowledge);
    });
  };
  worker_.run(map, [this](const std::string& reason) {
    queue_.post([this, text = "The photons cannot be looked at: " + reason] {
      busy_ = false;
      messages_.error(text);
    });
  });
}

}  // namespace guidelight

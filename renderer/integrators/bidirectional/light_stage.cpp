#include "renderer/integrators/bidirectional/light_stage.h"

#include <algorithm>

#include "renderer/image/technique_images.h"
#include "renderer/integrators/tiles.h"

namespace guidelight {

namespace {

/// Light paths draw other random numbers than the camera path of the same number.
constexpr uint64_t kLightPathStream = 0x6c69676874ull;

}  // namespace

LightStage::LightStage(const PassSetup& setup)
    : setup_(setup),
      walk_(setup.scene, TransportMode::Importance, &setup.weights),
      batch_(setup.scene, setup.weights.counts().emission, setup.guided) {}

void LightStage::trace(size_t first, size_t last, Film* film) {
  film_ = setup_.settings.light_tracing ? film : nullptr;
  photons_.clear();
  vertices_.reset(last - first);
  for (size_t begin = first; begin < last; begin += kTilePixels) {
    start(begin, std::min(begin + kTilePixels, last), begin - first);
    walk_.run(batch_.paths(), *this);
  }
  if (!film_) return;
  film_->add_splat_count(last - first);
  if (setup_.techniques) setup_.techniques->add_light_paths(last - first);
}

void LightStage::start(size_t first, size_t last, size_t first_slot) {
  batch_.reset(last - first);
  slots_.clear();
  for (size_t i = 0; i < last - first; ++i) {
    const Rng rng(setup_.seed ^ kLightPathStream, setup_.pass, first + i);
    if (!batch_.add(rng)) continue;  // contributes nothing, but counts
    slots_.push_back(static_cast<uint32_t>(first_slot + i));
  }
}

bool LightStage::visit(uint32_t index, Subpath& path, const PathVertex& vertex,
                       const Scattering& scattering) {
  const int length = vertex.length;
  if (length >= setup_.max_length) return false;
  if (scattering.is_connectible()) {
    const BidirectionalSettings& settings = setup_.settings;
    if (settings.merges() && (length > 1 || settings.merge_direct)) {
      add_photon(path, vertex, shaded_power(vertex, scattering));
    }
    if (settings.connections && length + 2 <= setup_.max_length) {
      vertices_.add(slots_[index], vertex);
    }
    if (film_ && setup_.is_shown(length + 1)) queue_splat(path, vertex, scattering);
  }
  return length + 2 <= setup_.max_length;
}

void LightStage::add_photon(Subpath& path, const PathVertex& vertex, Color power) {
  if (is_black(power)) return;
  photons_.push_back(make_photon(vertex.point.position, vertex.wo, power, vertex.length,
                                 vertex.is_caustic(), vertex.partials));
  if (path.guided) path.guided->left_photon(vertex.point.position);
}

void LightStage::queue_splat(Subpath& path, const PathVertex& vertex,
                             const Scattering& scattering) {
  const auto lens =
      connect_to_lens(setup_.scene.camera(), vertex, scattering, path.rng.next_vec2());
  if (!lens) return;
  const Camera& camera = setup_.scene.camera();
  const float eta = setup_.radius.eta(setup_.radius.seen_directly(camera, lens->distance));
  const float weight = path_weight(setup_.weights, vertex, *lens, eta);
  if (setup_.techniques) unweighted_.push_back({lens->contribution, vertex.length + 1});
  shadow_rays_.push_back(lens->shadow_ray);
  filter_u_.push_back(path.rng.next_vec2());
  splats_.push_back({.raster = lens->raster,
                     .contribution = lens->contribution * weight,
                     .direct = vertex.length == 1,
                     .caustic = vertex.is_caustic()});
}

void LightStage::record_techniques() {
  if (!setup_.techniques) return;
  for (size_t i = 0; i < splats_.size(); ++i) {
    if (blocked_[i]) continue;
    const glm::ivec2 pixel(splats_[i].raster);
    setup_.techniques->add({.s = unweighted_[i].s, .t = 1}, pixel.x, pixel.y,
                           splats_[i].contribution, unweighted_[i].contribution);
  }
  unweighted_.clear();
}

void LightStage::end_segment() {
  if (splats_.empty()) return;
  blocked_.resize(shadow_rays_.size());
  setup_.scene.occluded(shadow_rays_, blocked_);
  record_techniques();
  size_t visible = 0;
  for (size_t i = 0; i < splats_.size(); ++i) {
    if (blocked_[i]) continue;
    splats_[visible] = splats_[i];
    filter_u_[visible++] = filter_u_[i];
  }
  film_->add_splats({splats_.data(), visible}, {filter_u_.data(), visible});
  splats_.clear();
  filter_u_.clear();
  shadow_rays_.clear();
}

}  // namespace guidelight

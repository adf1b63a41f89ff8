#include "renderer/integrators/photon_mapping/photon_observer.h"

#include <algorithm>

namespace guidelight {

namespace {

/// Side of the cells in which photons become one, of the largest radius of an estimate.
constexpr float kCellSize = 0.03f;

bool is_sharp(const Path& path, int i, const SharpScattering& sharp) {
  if (!path.is_finite(i)) return true;
  const PathPoint& x = path.points[i];
  return (x.point.bsdf->lobes() & kLobeGlossy) &&
         sharp.is_above(std::max(x.pdf_to_eye, x.pdf_to_light) * survival_probability(x.point));
}

}  // namespace

std::optional<PhotonSite> photon_site(const Path& path, const SharpScattering& sharp) {
  int first = 0;  // diffuse event, counted from the eye
  for (int i = path.length() - 1; i >= 1; --i) {
    if (is_sharp(path, i, sharp)) continue;
    if (first > 0) return PhotonSite{i, false};
    first = i;
  }
  // All before it is sharp.
  return first > 1 ? std::optional(PhotonSite{first, true}) : std::nullopt;
}

PathVertex PhotonObserver::vertex_at(const Path& path, int i) const {
  PathVertex vertex{};
  vertex.point = path.points[i].point;
  vertex.wo = -path.points[i - 1].direction;
  vertex.medium = path.medium(setup_.scene, i - 1);
  vertex.length = i;
  vertex.survival = survival_probability(vertex.point);
  return vertex;
}

uint64_t PhotonObserver::cell(const PathVertex& vertex, bool caustic) const {
  // A corner of the scene has as many cells as it has walls.
  const Vec3 normal = vertex.point.geometric_normal;
  int axis = 0;
  for (int i = 1; i < 3; ++i) axis = std::abs(normal[i]) > std::abs(normal[axis]) ? i : axis;
  const bool outside = glm::dot(normal, vertex.wo) > 0;
  const uint64_t kind = axis * 4u + (outside ? 2u : 0u) + (caustic ? 1u : 0u);
  const float size = kCellSize * (caustic ? setup_.caustic : setup_.global).max_distance;
  return mix_bits(hash_position(glm::floor(vertex.point.position / size)) ^ kind);
}

void PhotonObserver::operator()(const Path& path, double weight) {
  const auto site = photon_site(path, setup_.global.sharp);
  if (!site) return;
  const PathVertex vertex = vertex_at(path, site->vertex);
  const uint64_t key = cell(vertex, site->caustic);
  const auto [place, is_new] = places_.try_emplace(key, static_cast<uint32_t>(deposits_.size()));
  if (is_new) deposits_.push_back({vertex, site->caustic, importance_at(vertex, site->caustic)});
  Deposit& deposit = deposits_[place->second];
  // What the state carries may differ all the same: vertices nearer to the light may be others.
  const bool arrives_alike = deposit.vertex.point.position == vertex.point.position &&
                             deposit.vertex.wo == vertex.wo &&
                             deposit.vertex.length == vertex.length;
  const Color importance =
      arrives_alike ? deposit.importance : importance_at(vertex, site->caustic);
  const Color added = state_power(path, *site, importance) * static_cast<float>(weight);
  deposit.power += added;
  if (!arrives_alike && rng_.next_float() * luminance(deposit.power) < luminance(added)) {
    deposit.vertex = vertex;
    deposit.importance = importance;
  }
}

Color PhotonObserver::importance_at(const PathVertex& vertex, bool caustic) const {
  const Scattering scattering(vertex.point, vertex.wo, TransportMode::Importance);
  return power_.importance(vertex, scattering, caustic);
}

Color PhotonObserver::state_power(const Path& path, const PhotonSite& site,
                                  Color importance) const {
  glm::dvec3 f(1.0);                    // f_map: what arrives
  double pdf = path.pdf_from_light(0);  // of a light path that leaves the same photon
  for (int i = 0; i < site.vertex; ++i) {
    const PathPoint& x = path.points[i];
    f *= glm::dvec3(x.value * x.transmittance) * double{x.arrival_eye};
    pdf *= path.pdf_from_light(i + 1);
    if (i > 0) pdf *= survival_probability(x.point);
  }
  return power_.of_state(f, pdf, importance);
}

PassPhotons PhotonObserver::photons() const {
  PassPhotons photons;
  for (const Deposit& deposit : deposits_) {
    auto& map = deposit.caustic ? photons.caustic : photons.global;
    if (!is_black(deposit.power)) {
      map.push_back(make_surface_photon(deposit.vertex, deposit.power, deposit.caustic));
    }
  }
  return photons;
}

}  // namespace guidelight

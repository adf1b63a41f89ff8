#include "renderer/integrators/bidirectional/camera_stage.h"

#include <algorithm>

#include "renderer/image/technique_images.h"

namespace guidelight {

VertexCache::VertexCache(const std::vector<StoredVertices>& batches) : batches_(batches) {
  begin_.push_back(0);
  for (const StoredVertices& batch : batches)
    begin_.push_back(begin_.back() + batch.vertices.size());
}

const StoredVertex& VertexCache::operator[](size_t i) const {
  const auto next = std::upper_bound(begin_.begin(), begin_.end(), i);
  const size_t batch = next - begin_.begin() - 1;
  return batches_[batch].vertices[i - begin_[batch]];
}

void CameraStage::PathState::extend(const Subpath& path) {
  if (path.length == 0) return;
  is_specular_tail = !path.is_connectible;
  if (is_specular_tail) return;
  ++finite_vertices;
  if (path.length == 1) first_is_finite = true;
}

void CameraStage::add(uint32_t index, int s, int t, Color contribution, float weight,
                      bool is_caustic, bool is_merging) {
  FilmSample& sample = states_[index].sample;
  const Color weighted = contribution * weight;
  // A merged path has one vertex that belongs to both sides.
  const int length = is_merging ? s + t - 2 : s + t - 1;
  (length <= 2 ? sample.direct : sample.indirect) += weighted;
  if (is_caustic) sample.caustic += weighted;
  if (is_merging) sample.merging += weighted;
  if (setup_.techniques) {
    const int width = tile_.x1 - tile_.x0;
    const auto i = static_cast<int>(index);
    setup_.techniques->add({s, t, is_merging}, tile_.x0 + i % width, tile_.y0 + i / width,
                           sample.filter_weight * weighted, sample.filter_weight * contribution);
  }
}

CameraStage::CameraStage(const PassSetup& setup)
    : setup_(setup), walk_(setup.scene, TransportMode::Radiance, &setup.weights) {}

void CameraStage::render(const PixelRegion& tile, const LightSide& light, Film& film) {
  light_ = light;
  tile_ = tile;
  start(tile, film.filter());
  walk_.run(paths_, *this);
  size_t i = 0;
  for (int y = tile.y0; y < tile.y1; ++y) {
    for (int x = tile.x0; x < tile.x1; ++x) film.add_sample(x, y, states_[i++].sample);
  }
  if (setup_.techniques) setup_.techniques->add_samples(tile);
}

void CameraStage::start(const PixelRegion& tile, const Filter& filter) {
  paths_.clear();
  states_.clear();
  const int width = setup_.scene.camera().width();
  for (int y = tile.y0; y < tile.y1; ++y) {
    for (int x = tile.x0; x < tile.x1; ++x) {
      Rng rng(setup_.seed, setup_.pass, static_cast<uint64_t>(y) * width + x);
      const Filter::Sample offset = filter.sample(rng.next_vec2());
      paths_.push_back(
          start_camera_path(setup_.scene, Vec2(x + 0.5f, y + 0.5f) + offset.offset, rng));
      PathState& state = states_.emplace_back();
      state.sample.filter_weight = offset.weight;
      if (setup_.radius.needs_footprint()) {
        const Subpath& path = paths_.back();
        state.footprint.emplace(path.ray.direction, path.is_parallel);
      }
    }
  }
}

void CameraStage::escaped(uint32_t index, Subpath& path) {
  const int length = path.length + 1;
  if (!setup_.is_shown(length)) return;
  PathState& state = states_[index];
  state.extend(path);
  for (const Light* light : setup_.scene.infinite_lights()) {
    const Color radiance = light->radiance_from(path.ray.direction);
    if (is_black(radiance)) continue;
    float weight = 1;
    if (length > 1) {
      const EmissionEnd end = end_at_infinity(setup_.scene, path, *light, state.is_direct_caustic(),
                                              setup_.guided_emission());
      weight = path_weight(setup_.weights, end, state.eta);
    }
    add(index, 0, length + 1, path.throughput * radiance, weight, state.is_caustic());
  }
}

void CameraStage::expect(Vec3 position, bool soon) const {
  if (light_.photons) light_.photons->prefetch(position, soon);
}

bool CameraStage::visit(uint32_t index, Subpath& path, const PathVertex& vertex,
                        const Scattering& scattering) {
  const BidirectionalSettings& settings = setup_.settings;
  const bool ends_early = settings.ends_at_first_finite_vertex();
  if (ends_early && !vertex.is_specular_chain) return false;
  const int length = vertex.length;
  PathState& state = states_[index];
  state.extend(path);
  if (state.footprint && vertex.is_specular_chain) {
    state.footprint->arrive(setup_.scene, path.origin, vertex);
  }
  if (length == 1) record_first_hit(state.sample, vertex.point, vertex.hit.t);
  if (vertex.point.light && setup_.is_shown(length)) add_emission(index, path, vertex);
  if (length >= setup_.max_length) return false;
  if (!scattering.is_connectible()) return true;

  if (vertex.is_specular_chain) {
    state.radius = setup_.radius.at(state.footprint ? &*state.footprint : nullptr);
    state.eta = setup_.radius.eta(state.radius);
  }
  if (settings.next_event && setup_.is_shown(length + 1)) {
    connect_light(index, path, vertex, scattering);
  }
  if (light_.own) connect_own_path(index, vertex, scattering);
  if (light_.cache) connect_random_vertices(index, path, vertex, scattering);
  if (light_.photons) merge_within_radius(index, vertex, scattering);
  if (light_.nearest) merge_nearest(index, vertex, scattering);
  // A coat over a finite lobe: the path may still be a specular one.
  return !ends_early || (vertex.point.bsdf->lobes() & kLobeDelta);
}

void CameraStage::add_emission(uint32_t index, const Subpath& path, const PathVertex& vertex) {
  const PathState& state = states_[index];
  const Color radiance = vertex.point.light->radiance(vertex.point, vertex.wo);
  if (is_black(radiance)) return;
  float weight = 1;
  if (vertex.length > 1) {
    const EmissionEnd end = end_on_light(setup_.scene, path, vertex, state.is_direct_caustic(),
                                         setup_.guided_emission());
    weight = path_weight(setup_.weights, end, state.eta);
  }
  add(index, 0, vertex.length + 1, vertex.throughput * radiance, weight, state.is_caustic());
}

void CameraStage::connect_light(uint32_t index, Subpath& path, const PathVertex& vertex,
                                const Scattering& scattering) {
  const float u_light = path.rng.next_float();
  const auto direct = connect_to_light(setup_.scene, vertex, scattering, u_light,
                                       path.rng.next_vec2(), setup_.guided_emission());
  if (!direct) return;
  const float weight = path_weight(setup_.weights, vertex, *direct, states_[index].eta);
  queue(direct->shadow_ray, {index, 1, vertex.length + 1, direct->contribution, weight});
}

void CameraStage::connect_own_path(uint32_t index, const PathVertex& vertex,
                                   const Scattering& scattering) {
  const LightVertices& own = *light_.own;
  if (own.last.empty()) return;
  uint32_t next = own.last[index % own.last.size()];
  for (; next != kNoVertex; next = own.previous[next]) {
    connect(index, own.vertices[next], vertex, scattering, 1.0f);
  }
}

void CameraStage::connect_random_vertices(uint32_t index, Subpath& path, const PathVertex& vertex,
                                          const Scattering& scattering) {
  const VertexCache& cache = *light_.cache;
  if (cache.size() == 0) return;
  const int picks = setup_.settings.random_vertices;
  // One path is found size/picks/N_L times as seldom as by N_L light paths that are all connected.
  const float scale = static_cast<float>(cache.size()) /
                      (static_cast<float>(picks) * static_cast<float>(setup_.light_path_count));
  for (int i = 0; i < picks; ++i) {
    const auto chosen =
        static_cast<size_t>(path.rng.next_float() * static_cast<float>(cache.size()));
    const PathVertex light = cache[std::min(chosen, cache.size() - 1)].restore(setup_.scene);
    connect(index, light, vertex, scattering, scale);
  }
}

void CameraStage::connect(uint32_t index, const PathVertex& light, const PathVertex& vertex,
                          const Scattering& scattering, float scale) {
  const int length = light.length + vertex.length + 1;
  if (!setup_.is_shown(length)) return;
  const Scattering light_scattering(light.point, light.wo, TransportMode::Importance);
  const auto connection = connect_vertices(light, light_scattering, vertex, scattering);
  if (!connection) return;
  const float weight = path_weight(setup_.weights, light, vertex, *connection, states_[index].eta);
  queue(connection->shadow_ray,
        {index, light.length + 1, vertex.length + 1, connection->contribution * scale, weight});
}

void CameraStage::merge_within_radius(uint32_t index, const PathVertex& vertex,
                                      const Scattering& scattering) {
  const float radius = states_[index].radius;
  if (!(radius > 0)) return;
  const float kernel = kernel_value(Kernel::Constant, 0, sqr(radius));
  light_.photons->for_each_within(vertex.point.position, radius, [&](const Photon& photon, float) {
    merge(index, vertex, scattering, photon, kernel);
  });
}

void CameraStage::merge_nearest(uint32_t index, const PathVertex& vertex,
                                const Scattering& scattering) {
  neighbors_.resize(setup_.settings.neighbors);
  const Neighbors nearest = light_.nearest->nearest(vertex.point.position, neighbors_.size(),
                                                    states_[index].radius, neighbors_);
  const auto kernel = static_cast<Kernel>(setup_.settings.kernel);
  for (const Neighbor& neighbor : nearest.found) {
    const float value = kernel_value(kernel, neighbor.distance_squared, nearest.radius_squared);
    if (value > 0) {
      merge(index, vertex, scattering, light_.nearest->items()[neighbor.index], value);
    }
  }
}

void CameraStage::merge(uint32_t index, const PathVertex& vertex, const Scattering& scattering,
                        const Photon& photon, float kernel) {
  const MisWeights& weights = setup_.weights;
  if (!setup_.is_shown(photon.length() + vertex.length)) return;
  if (photon.caustic() && vertex.length == 1 && !weights.counts().merge_direct) return;
  const Vec3 wi = photon.direction();
  const BsdfEvaluation bsdf = scattering.evaluate(wi);
  if (is_black(bsdf.value)) return;
  float weight = 1;
  if (setup_.settings.kind != BidirectionalKind::ProbabilisticPpm) {
    weight = path_weight(weights, vertex,
                         {.photon = photon.partials,
                          .photon_length = photon.length(),
                          .pdf_to_light = bsdf.pdf * vertex.survival,
                          .pdf_to_camera = bsdf.pdf_reverse * vertex.survival},
                         states_[index].eta);
  }
  // Photons bring the cosine with them: see shaded_power().
  const float scale =
      kernel / (scattering.shading_cosine(wi) * static_cast<float>(setup_.light_path_count));
  add(index, photon.length() + 1, vertex.length + 1,
      vertex.throughput * bsdf.value * photon.power() * scale, weight,
      photon.caustic() && vertex.is_specular_chain, true);
}

void CameraStage::queue(const Ray& shadow_ray, const PendingLight& light) {
  shadow_rays_.push_back(shadow_ray);
  pending_.push_back(light);
}

void CameraStage::end_segment() {
  blocked_.resize(shadow_rays_.size());
  setup_.scene.occluded(shadow_rays_, blocked_);
  for (size_t i = 0; i < pending_.size(); ++i) {
    const PendingLight& light = pending_[i];
    if (!blocked_[i]) add(light.path, light.s, light.t, light.contribution, light.weight);
  }
  shadow_rays_.clear();
  pending_.clear();
}

}  // namespace guidelight

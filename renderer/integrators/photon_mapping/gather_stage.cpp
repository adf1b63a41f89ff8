#include "renderer/integrators/photon_mapping/gather_stage.h"

#include <algorithm>

namespace guidelight {

GatherStage::GatherStage(const PhotonMappingPass& setup, const GatheredLight& light,
                         const PhotonMaps& maps)
    : setup_(setup),
      maps_(maps),
      rule_(setup),
      gather_(setup.scene, light),
      walk_(setup.scene, TransportMode::Radiance) {}

void GatherStage::render(const PixelRegion& tile, Film& film) {
  tile_ = tile;
  CameraPaths camera = start_camera_paths(setup_, tile, film.filter());
  samples_.assign(camera.paths.size(), {});
  for (size_t i = 0; i < samples_.size(); ++i) {
    samples_[i].filter_weight = camera.filter_weights[i];
  }
  walk_.run(camera.paths, *this);
  size_t i = 0;
  for (int y = tile.y0; y < tile.y1; ++y) {
    for (int x = tile.x0; x < tile.x1; ++x) film.add_sample(x, y, pixel_sample(i++));
  }
}

FilmSample GatherStage::pixel_sample(size_t i) const {
  const auto count = static_cast<size_t>(setup_.settings.camera_samples);
  FilmSample sum;
  for (const FilmSample& sample : std::span(samples_).subspan(i * count, count)) {
    const float share = sample.filter_weight / static_cast<float>(count);
    sum.direct += sample.direct * share;
    sum.indirect += sample.indirect * share;
    sum.caustic += sample.caustic * share;
    sum.merging += sample.merging * share;
    sum.albedo += sample.albedo * share;
    sum.normal += sample.normal * share;
    if (sample.depth < kInfinity) sum.depth = sample.depth;
  }
  return sum;
}

void GatherStage::add(uint32_t index, int length, Color contribution) {
  FilmSample& sample = samples_[index];
  (length <= 2 ? sample.direct : sample.indirect) += contribution;
}

void GatherStage::escaped(uint32_t index, Subpath& path) {
  const int length = path.length + 1;
  if (!rule_.reaches(path) || !setup_.is_shown(length)) return;
  const Vec3 towards = path.ray.direction;
  for (const Light* light : setup_.scene.infinite_lights()) {
    const Color radiance = light->radiance_from(towards);
    if (is_black(radiance)) continue;
    const float pdf_direct =
        path.is_connectible && path.length > 0
            ? light->pdf_direct_from(towards) * setup_.scene.light_probability(*light)
            : 0.0f;
    add(index, length, path.throughput * radiance * hit_weight(path.pdf, pdf_direct));
  }
}

bool GatherStage::visit(uint32_t index, Subpath& path, const PathVertex& vertex,
                        const Scattering& scattering) {
  if (!rule_.reaches(path)) return false;
  const int length = vertex.length;
  if (length == 1) record_first_hit(samples_[index], vertex.point, vertex.hit.t);
  if (vertex.point.light && setup_.is_shown(length)) {
    const Light& light = *vertex.point.light;
    const float pdf_direct =
        path.is_connectible && length > 1
            ? light.pdf_direct(path.origin, vertex.point) * setup_.scene.light_probability(light)
            : 0.0f;
    add(index, length,
        vertex.throughput * light.radiance(vertex.point, vertex.wo) *
            hit_weight(path.pdf, pdf_direct));
  }
  if (length >= setup_.global.max_length) return false;
  if (vertex.is_connectible()) {
    Rng rng = rule_.rng(tile_, index, vertex);
    if (rule_.gathers(vertex)) {
      add_caustic(index, vertex, scattering);
      add_indirect(index, vertex, scattering, rng);
    }
    Rng direct_rng(rng.next_uint(), setup_.pass, 1);
    if (setup_.is_shown(length + 1)) add_direct(index, vertex, scattering, direct_rng);
  }
  return SharpScattering::is_possible(*vertex.point.bsdf);
}

float GatherStage::hit_weight(float pdf, float pdf_direct) const {
  return pdf / (pdf + static_cast<float>(setup_.settings.light_samples) * pdf_direct);
}

void GatherStage::add_direct(uint32_t index, const PathVertex& vertex, const Scattering& scattering,
                             Rng& rng) {
  const auto count = static_cast<float>(setup_.settings.light_samples);
  for (int i = 0; i < setup_.settings.light_samples; ++i) {
    // Stratified over the lights.
    const float u_light = (static_cast<float>(i) + rng.next_float()) / count;
    const auto direct = connect_to_light(setup_.scene, vertex, scattering,
                                         std::min(u_light, kOneMinusEpsilon), rng.next_vec2());
    if (!direct) continue;
    const Vec3 wi = glm::normalize(direct->shadow_ray.direction);
    const bool is_sharp = setup_.global.sharp(vertex, scattering, wi);
    const float weight = is_sharp ? 1 / (count + direct->hit_ratio) : 1 / count;
    shadow_rays_.push_back(direct->shadow_ray);
    pending_.push_back({index, vertex.length + 1, direct->contribution * weight});
  }
}

void GatherStage::add_caustic(uint32_t index, const PathVertex& vertex,
                              const Scattering& scattering) {
  const Color radiance =
      vertex.throughput * maps_.caustic.radiance(vertex, scattering, setup_.caustic);
  samples_[index].indirect += radiance;
  samples_[index].caustic += radiance;
  samples_[index].merging += radiance;
}

void GatherStage::add_indirect(uint32_t index, const PathVertex& vertex,
                               const Scattering& scattering, const Rng& rng) {
  Color radiance(0.0f);
  const auto value = rule_.cached_value(vertex, scattering);
  if (value && is_black(*value)) return;
  const auto irradiance =
      value ? maps_.cache.interpolate(vertex.point.position, normal_towards_viewer(vertex),
                                      rule_.cache_key(vertex))
            : std::nullopt;
  if (irradiance) {
    radiance = *value * *irradiance;
  } else {
    // The rays of a pixel are shared by its paths, in proportion to what they still carry.
    const float rays = static_cast<float>(setup_.settings.gather_rays) /
                       static_cast<float>(setup_.settings.camera_samples) *
                       std::min(1.0f, max_component(vertex.throughput));
    radiance = gather_.radiance(vertex, scattering, std::max(1, static_cast<int>(rays)), rng);
  }
  samples_[index].indirect += vertex.throughput * radiance;
  samples_[index].merging += vertex.throughput * radiance;
}

void GatherStage::end_segment() {
  blocked_.resize(shadow_rays_.size());
  setup_.scene.occluded(shadow_rays_, blocked_);
  for (size_t i = 0; i < pending_.size(); ++i) {
    if (!blocked_[i]) add(pending_[i].path, pending_[i].length, pending_[i].contribution);
  }
  shadow_rays_.clear();
  pending_.clear();
}

}  // namespace guidelight

#include "renderer/integrators/progressive_photons/camera_walk.h"

namespace guidelight {

namespace {

/// The i-th of a sequence that covers the unit square evenly however many there are (Roberts 2018,
/// "The Unreasonable Effectiveness of Quasirandom Sequences").
Vec2 evenly_spread(Vec2 offset, int i) {
  return glm::fract(offset + static_cast<float>(i) * Vec2(0.75487767f, 0.56984029f));
}

}  // namespace

void CameraWalk::trace(const PixelRegion& tile, const Filter& filter, const Measure& measure) {
  subpaths_.clear();
  paths_.clear();
  measure_ = &measure;
  const int width = scene_.camera().width();
  for (int y = tile.y0; y < tile.y1; ++y) {
    for (int x = tile.x0; x < tile.x1; ++x) {
      const uint64_t pixel = static_cast<uint64_t>(y) * width + x;
      Vec2 offset(0);
      for (int i = 0; i < settings_.per_pixel; ++i) {
        Rng rng(settings_.seed, settings_.pass, pixel * settings_.per_pixel + i);
        if (i == 0) offset = rng.next_vec2();
        const Filter::Sample at = filter.sample(evenly_spread(offset, i));
        subpaths_.push_back(start_camera_path(scene_, Vec2(x + 0.5f, y + 0.5f) + at.offset, rng));
        CameraPath& path = paths_.emplace_back();
        path.weight = at.weight / static_cast<float>(settings_.per_pixel);
        if (settings_.need_footprints) {
          path.footprint.emplace(subpaths_.back().ray.direction, subpaths_.back().is_parallel);
        }
      }
    }
  }
  walk_.run(subpaths_, *this);
}

FilmSample CameraWalk::pixel_sample(size_t i) const {
  FilmSample sum;
  float depth = 0;
  int hits = 0;
  for (int j = 0; j < settings_.per_pixel; ++j) {
    const CameraPath& path = paths_[i * settings_.per_pixel + j];
    sum.direct += path.weight * path.sample.direct;
    sum.indirect += path.weight * path.sample.indirect;
    sum.albedo += path.weight * path.sample.albedo;
    sum.normal += path.weight * path.sample.normal;
    if (path.sample.depth < kInfinity) depth += path.sample.depth, ++hits;
  }
  if (hits > 0) sum.depth = depth / static_cast<float>(hits);
  return sum;
}

void CameraWalk::add_emission(uint32_t index, int length, Color radiance) {
  if (length < settings_.min_length) return;
  FilmSample& sample = paths_[index].sample;
  (length <= 2 ? sample.direct : sample.indirect) += radiance;
}

void CameraWalk::escaped(uint32_t index, Subpath& path) {
  if (!path.is_specular_chain) return;
  for (const Light* light : scene_.infinite_lights()) {
    add_emission(index, path.length + 1,
                 path.throughput * light->radiance_from(path.ray.direction));
  }
}

bool CameraWalk::visit(uint32_t index, Subpath& subpath, const PathVertex& vertex,
                       const Scattering& scattering) {
  if (!vertex.is_specular_chain) return false;  // the light that comes this way has been measured
  CameraPath& path = paths_[index];
  if (path.footprint) path.footprint->arrive(scene_, subpath.origin, vertex);
  if (vertex.length == 1) record_first_hit(path.sample, vertex.point, vertex.hit.t);
  if (const Light* light = vertex.point.light) {
    add_emission(index, vertex.length,
                 vertex.throughput * light->radiance(vertex.point, vertex.wo));
  }
  if (vertex.length >= settings_.max_length) return false;
  if (scattering.is_connectible()) (*measure_)(index, vertex, scattering);
  return vertex.point.bsdf->lobes() & kLobeDelta;
}

}  // namespace guidelight

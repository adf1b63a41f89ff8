#include "ui/pixel_probe.h"

#include <algorithm>

namespace guidelight {
namespace {

std::optional<SeenSurface> look_through(const Scene& scene, int x, int y) {
  const auto point = seen_through_pixel(scene, {x, y});
  if (!point) return std::nullopt;
  return SeenSurface{scene.shape_name(point->shape), scene.bsdf_name(point->shape), point->position,
                     glm::length(point->position - scene.camera().position()),
                     point->light != nullptr};
}

}  // namespace

std::optional<SurfacePoint> seen_through_pixel(const Scene& scene, glm::ivec2 pixel) {
  const Ray ray = scene.camera().sample_ray(Vec2(pixel) + 0.5f, Vec2(0.5f)).ray;
  const Hit hit = scene.intersect(ray);
  return hit.valid() ? std::optional(scene.surface_point(ray, hit)) : std::nullopt;
}

std::optional<PixelReport> probe_pixel(const Scene& scene, const Snapshot& snapshot, int x, int y) {
  const Image& beauty = snapshot.layer(Layer::Beauty);
  if (beauty.empty() || x < 0 || y < 0 || x >= snapshot.full_width || y >= snapshot.full_height) {
    return std::nullopt;
  }
  const auto matching = [](int64_t i, int size, int full_size) {
    return static_cast<int>(std::min<int64_t>(i * size / full_size, size - 1));
  };
  const int column = matching(x, beauty.width(), snapshot.full_width);
  const int row = matching(y, beauty.height(), snapshot.full_height);
  const auto value = [&](Layer layer) { return snapshot.layer(layer).color(column, row); };
  PixelReport report;
  report.x = x;
  report.y = y;
  report.radiance = value(Layer::Beauty);
  report.direct = value(Layer::Direct);
  report.indirect = value(Layer::Indirect);
  report.caustic = value(Layer::Caustic);
  report.connection = value(Layer::Connection);
  report.merging = value(Layer::Merging);
  report.albedo = value(Layer::Albedo);
  report.normal = value(Layer::Normal);
  report.depth = value(Layer::Depth).r;
  report.samples = value(Layer::SampleCount).r;
  report.standard_error = safe_sqrt(value(Layer::Variance).r);
  const bool same_size = scene.camera().width() == snapshot.full_width &&
                         scene.camera().height() == snapshot.full_height;
  if (same_size) report.seen = look_through(scene, x, y);
  return report;
}

}  // namespace guidelight

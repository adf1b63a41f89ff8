#include "ui/tools/tool.h"

namespace guidelight {

Ray pick_ray(const ToolView& view, Vec2 screen) {
  Ray ray = view.projection.ray_through(screen);
  const float side = glm::dot(view.clip_plane, Vec4(ray.origin, 1));
  const float slope = glm::dot(Vec3(view.clip_plane), ray.direction);
  if (side < 0) {
    if (slope > 0) {
      ray.origin += (-side / slope) * ray.direction;
    } else {
      ray.t_max = 0;
    }
  } else if (slope < 0) {
    ray.t_max = side / -slope;
  }
  return ray;
}

std::optional<SurfacePoint> pick_surface(const Scene& scene, const ToolView& view) {
  const Ray ray = pick_ray(view, view.mouse);
  const Hit hit = scene.intersect(ray);
  if (!hit.valid()) return std::nullopt;
  return scene.surface_point(ray, hit);
}

}  // namespace guidelight

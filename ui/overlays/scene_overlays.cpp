#include "ui/overlays/scene_overlays.h"

#include <array>

#include "ui/overlays/world_painter.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace guidelight {
namespace {

constexpr size_t kMostLights = 128;     // that get a mark
constexpr float kFrustumShare = 0.12f;  // its length, of the scene's radius
constexpr ImU32 kLightMark = IM_COL32(255, 214, 120, 255);
constexpr ImU32 kCameraMark = IM_COL32(120, 190, 255, 255);

}  // namespace

void draw_overlays(const Document&, const ToolView&, ImDrawList&) {}

void draw_lights(const Scene& scene, const ToolView& view, ImDrawList& list) {
  WorldPainter painter(scene, view, list);
  size_t marked = 0;
  for (const auto& light : scene.lights()) {
    if (light->is_infinite() || light->is_delta_direction() || ++marked > kMostLights) continue;
    const auto emission = light->sample_emission(Vec2(0.5f), Vec2(0.5f));
    if (!emission) continue;
    const Vec3 position =
        light->is_delta_position() ? emission->ray.origin : emission->point.position;
    painter.dot(position, kLightMark, scaled(2.5f));
    painter.ring(position, kLightMark, scaled(6), scaled(1));
  }
}

void draw_render_camera(const Scene& scene, const ToolView& view, ImDrawList& list) {
  const Camera& camera = scene.camera();
  const float length = kFrustumShare * scene.bounds().radius();
  // From inside it would only be in the way.
  if (glm::length(view.projection.seen_from(camera.position()) - camera.position()) < length)
    return;
  const Vec2 size(camera.width(), camera.height());
  const Vec2 corners[] = {{0, 0}, {size.x, 0}, size, {0, size.y}};
  WorldPainter painter(scene, view, list);
  std::array<Vec3, 5> far_corners;
  for (int i = 0; i < 4; ++i) {
    const CameraSample sample = camera.sample_ray(corners[i], Vec2(0.5f));
    const float cosine = glm::dot(sample.ray.direction, camera.forward());
    far_corners[i] = sample.lens_position + sample.ray.direction * (length / cosine);
    painter.line(sample.lens_position, far_corners[i], kCameraMark, scaled(1));
  }
  far_corners[4] = far_corners[0];
  painter.polyline(far_corners, kCameraMark, scaled(1.5f));
  painter.dot(camera.position(), kCameraMark, scaled(3));
}

}  // namespace guidelight

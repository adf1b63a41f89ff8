#include "ui/overlays/scene_overlays.h"

#include <array>

#include "ui/overlays/guide_overlay.h"
#include "ui/overlays/world_painter.h"
#include "ui/photons/gather_disc.h"
#include "ui/pixel_probe.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace guidelight {
namespace {

constexpr size_t kMostLights = 128;     // that get a mark
constexpr float kFrustumShare = 0.12f;  // its length, of the scene's radius
constexpr ImU32 kLightMark = IM_COL32(255, 214, 120, 255);
constexpr ImU32 kCameraMark = IM_COL32(120, 190, 255, 255);

void draw_disc(const GatherDisc& disc, const SurfacePoint& point, WorldPainter& painter,
               ImU32 color) {
  painter.circle(point.position, point.geometric_normal, disc.radius, color, scaled(1.5f));
}

/// Around what the inspected pixel sees: the disc whose photons its estimate counts.
void draw_inspected_disc(const Document& document, const ToolView& view, ImDrawList& list) {
  const auto& pixel = document.view().inspected_pixel;
  const auto disc = pixel ? progressive_disc(document, *pixel) : std::nullopt;
  if (!disc) return;
  const auto scene = document.current_scene();
  const auto point = seen_through_pixel(*scene, *pixel);
  WorldPainter painter(*scene, view, list);
  if (point) draw_disc(*disc, *point, painter, palette::kText);
}

/// The same under the mouse, in words too.
void draw_hovered_disc(const Document& document, const PhotonKnowledge& photons,
                       const ToolView& view, ImDrawList& list) {
  const auto point = pick_surface(document.scene(), view);
  if (!point) return;
  const auto& pixel = document.view().hovered_pixel;
  auto disc = pixel ? progressive_disc(document, *pixel) : std::nullopt;
  if (!disc) disc = gather_disc(document, photons.search, *point);
  if (!disc) return;
  WorldPainter painter(document.scene(), view, list);
  draw_disc(*disc, *point, painter, palette::kAccent);
  draw_note(list, view.mouse + Vec2(scaled(16), scaled(14)), disc->text);
}

}  // namespace

void draw_overlays(const Document& document, const PhotonKnowledge* photons, const ToolView& view,
                   ImDrawList& list) {
  if (document.photon_view().shown && document.picture()) {
    draw_inspected_disc(document, view, list);
    if (photons && view.hovered) draw_hovered_disc(document, *photons, view, list);
  }
  draw_harvest(document, view, list);
  draw_guides(document, view, list);
}

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

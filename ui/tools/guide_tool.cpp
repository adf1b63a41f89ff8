#include "ui/tools/guide_tool.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "ui/guides/new_guide.h"
#include "ui/overlays/world_painter.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace guidelight {
namespace {

constexpr float kPointLightReach = 12;  // of the mouse [pixels at scale 1]
constexpr float kSwingBegins = 6;       // after the mouse has moved this far [pixels at scale 1]

std::optional<LightPlace> light_under_mouse(const Scene& scene, const ToolView& view) {
  const auto is_near = [&](Vec3 position) {
    const auto screen = view.projection.to_screen(position);
    return screen && glm::distance(*screen, view.mouse) < scaled(kPointLightReach);
  };
  return pick_light(scene, pick_ray(view, view.mouse), is_near);
}

}  // namespace

std::string GuideTool::hint() const {
  if (!problem_.empty()) return problem_;
  if (vertex_drag_.active()) return "The rest of the path is traced again as you drag";
  if (draft_.empty()) return "Click a light to begin a guide path; Esc puts the tool away";
  if (preview_ && !preview_->problem.empty() && !preview_->vertices.empty())
    return "Not there: " + preview_->problem;
  if (draft_.segments() == 0) {
    return "Click where its light should go first; dragging from the light swings a ray";
  }
  return "Click the next surface; Enter or a double click ends the path, Backspace takes back";
}

void GuideTool::hover(Document& document, const ToolView& view) {
  const Scene& scene = document.scene();
  preview_.reset();
  hovered_light_.reset();
  if (draft_.empty()) {
    vertex_drag_.hover(document, view);
    hovered_light_ = light_under_mouse(scene, view);
    return;
  }
  vertex_drag_.leave();
  if (const auto target = pick_surface(scene, view)) {
    preview_ = draft_.aim(scene, *target, document.guide_view().choice);
  }
}

void GuideTool::leave() {
  preview_.reset();
  hovered_light_.reset();
  vertex_drag_.leave();
}

void GuideTool::press(Document& document, const ToolView& view) {
  problem_.clear();
  if (draft_.empty()) {
    if (!vertex_drag_.press(document, view)) press_light(document, view);
    return;
  }
  if (view.double_click && draft_.segments() > 0) {
    finish(document);
    return;
  }
  hover(document, view);
  if (preview_ && preview_->problem.empty() && !preview_->vertices.empty()) {
    draft_.add(*std::exchange(preview_, {}));
  }
}

void GuideTool::press_light(Document& document, const ToolView& view) {
  const auto light = light_under_mouse(document.scene(), view);
  if (!light) {
    problem_ = "That is no light: a guide path begins on one";
    return;
  }
  draft_.begin(document.scene(), *light);
  hovered_light_.reset();
  light_pressed_at_ = view.mouse;
}

void GuideTool::drag(Document& document, const ToolView& view) {
  if (vertex_drag_.active()) {
    vertex_drag_.drag(document, view);
  } else if (light_pressed_at_ &&
             glm::distance(*light_pressed_at_, view.mouse) > scaled(kSwingBegins)) {
    swing(document, view);
  }
}

/// Traces the path that leaves the light towards what is under the mouse.
void GuideTool::swing(Document& document, const ToolView& view) {
  const auto start = draft_.light_position();
  const auto target = pick_surface(document.scene(), view);
  if (!start || !target) return;
  const Vec3 way = target->position - *start;
  if (!(glm::length(way) > 0)) return;
  const auto path = trace_guide(document.scene(), *start, glm::normalize(way),
                                document.guide_view().swing_bounces, document.guide_view().choice);
  if (path) draft_.take(document.scene(), *path);
}

void GuideTool::release(Document& document, const ToolView&) {
  if (vertex_drag_.active()) vertex_drag_.release(document);
  light_pressed_at_.reset();
}

bool GuideTool::take(Document& document, ToolCommand command) {
  problem_.clear();
  preview_.reset();
  switch (command) {
    case ToolCommand::Finish:
      if (draft_.segments() == 0) return false;
      finish(document);
      return true;
    case ToolCommand::RemoveLast:
      // Also where nothing is left to take back: the key means something else without the tool.
      if (!draft_.empty()) draft_.remove_last();
      return true;
    case ToolCommand::Cancel:
      if (draft_.empty()) finished_ = true;
      draft_.clear();
      return true;
  }
  return false;
}

void GuideTool::finish(Document& document) {
  add_guide(document, draft_.path(), "new guide");
  draft_.clear();
  preview_.reset();
}

void GuideTool::draw(const Document& document, const ToolView& view, ImDrawList& list) const {
  WorldPainter painter(document.scene(), view, list);
  vertex_drag_.draw(document, view, list);
  if (hovered_light_ && hovered_light_->towards_sky == Vec3(0)) {
    painter.ring(hovered_light_->point.position, palette::kAccent, scaled(8), scaled(2));
  }
  std::vector<Vec3> points = draft_.points();
  painter.polyline(points, palette::kAccent, scaled(2.5f));
  for (const Vec3 point : points) painter.dot(point, palette::kAccent, scaled(4));
  if (!preview_) return;
  const bool good = preview_->problem.empty();
  const ImU32 color = good ? faded(palette::kAccent, 0.75f) : palette::kError;
  std::vector<Vec3> next;
  if (!points.empty()) next.push_back(points.back());
  for (const GuideVertex& vertex : preview_->vertices) next.push_back(vertex.position);
  painter.polyline(next, color, scaled(1.5f));
  if (!preview_->vertices.empty()) {
    painter.ring(preview_->vertices.back().position, color, scaled(6), scaled(1.5f));
  }
}

}  // namespace guidelight

#include "ui/guides/vertex_drag.h"

#include "ui/guides/guide_editing.h"
#include "ui/overlays/world_painter.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace guidelight {
namespace {

constexpr float kReach = 10;  // of the mouse around a vertex [pixels at scale 1]

/// The handle nearest to the mouse within reach; those of the selected guide go first.
std::optional<GuideHandle> handle_under_mouse(const Document& document, const ToolView& view) {
  std::optional<GuideHandle> nearest;
  float smallest = scaled(kReach);
  const auto& guides = *document.guides();
  for (size_t guide = 0; guide < guides.size(); ++guide) {
    const float bonus = document.guide_view().selected == guide ? 0.5f : 1.0f;
    for (int i = 0; i < static_cast<int>(guides[guide].vertices.size()); ++i) {
      const auto screen = view.projection.to_screen(guides[guide].vertices[i].position);
      if (!screen) continue;
      const float distance = bonus * glm::distance(*screen, view.mouse);
      if (distance >= smallest) continue;
      smallest = distance;
      nearest = GuideHandle{guide, i};
    }
  }
  return nearest;
}

/// The vertex closest to where the mouse has put one; tracing may have changed their number.
int vertex_at(const GuidePath& guide, Vec3 position) {
  int nearest = 0;
  for (int i = 1; i < static_cast<int>(guide.vertices.size()); ++i) {
    if (glm::distance(guide.vertices[i].position, position) <
        glm::distance(guide.vertices[nearest].position, position)) {
      nearest = i;
    }
  }
  return nearest;
}

}  // namespace

void VertexDrag::hover(const Document& document, const ToolView& view) {
  handle_.reset();
  if (document.guide_view().shown) handle_ = handle_under_mouse(document, view);
}

bool VertexDrag::press(Document& document, const ToolView& view) {
  hover(document, view);
  active_ = handle_.has_value();
  if (active_) document.guide_view().selected = handle_->guide;
  guides_ = document.guides();
  return active_;
}

void VertexDrag::drag(Document& document, const ToolView& view) {
  if (document.guides() != guides_) handle_.reset();
  if (!handle_) return;
  const Scene& scene = document.scene();
  const auto target = pick_surface(scene, view);
  auto guides = *document.guides();
  if (!target) return;
  GuidePath& guide = guides[handle_->guide];
  guide = move_guide_vertex(scene, guide, handle_->vertex, *target);
  handle_->vertex = vertex_at(guide, target->position);
  document.edit_guides(std::move(guides), "drag of a vertex", "drag");
  guides_ = document.guides();
}

void VertexDrag::release(Document& document) {
  active_ = false;
  document.seal_edits();
}

void VertexDrag::draw(const Document& document, const ToolView& view, ImDrawList& list) const {
  if (!handle_ || handle_->guide >= document.guides()->size()) return;
  const GuidePath& guide = (*document.guides())[handle_->guide];
  if (handle_->vertex >= static_cast<int>(guide.vertices.size())) return;
  WorldPainter(document.scene(), view, list)
      .ring(guide.vertices[handle_->vertex].position, palette::kText, scaled(9), scaled(1.5f));
}

}  // namespace guidelight

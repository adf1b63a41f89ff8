#include "ui/tools/inspect_tool.h"

#include <algorithm>

#include "ui/theme.h"
#include "ui/widgets.h"

namespace guidelight {

void InspectTool::hover(Document& document, const ToolView& view) {
  vertex_drag_.hover(document, view);
}

void InspectTool::press(Document& document, const ToolView& view) {
  if (!vertex_drag_.press(document, view)) pick_pixel(document, view);
}

void InspectTool::drag(Document& document, const ToolView& view) {
  if (vertex_drag_.active()) {
    vertex_drag_.drag(document, view);
  } else {
    pick_pixel(document, view);
  }
}

void InspectTool::release(Document& document, const ToolView&) {
  if (vertex_drag_.active()) vertex_drag_.release(document);
}

void InspectTool::pick_pixel(Document& document, const ToolView& view) const {
  if (!view.picture) return;
  const Vec2 pixel = view.picture->to_pixel(view.mouse);
  const RenderSettings& settings = document.settings();
  const glm::ivec2 picked = glm::ivec2(glm::floor(pixel));
  const bool inside =
      picked.x >= 0 && picked.y >= 0 && picked.x < settings.width && picked.y < settings.height;
  document.view().forget_picked();
  if (inside) document.view().inspected_pixel = picked;
}

void InspectTool::draw(const Document& document, const ToolView& view, ImDrawList& list) const {
  vertex_drag_.draw(document, view, list);
  const auto& pixel = document.view().inspected_pixel;
  if (!pixel || !view.picture) return;
  const ViewTransform& transform = *view.picture;
  const Vec2 center = transform.to_screen(Vec2(*pixel) + 0.5f);
  const float half = std::max(scaled(5), 0.5f * transform.scale() + 1);
  const ImVec2 low = to_imgui(center - half);
  const ImVec2 high = to_imgui(center + half);
  list.AddRect(low, high, IM_COL32(0, 0, 0, 180), 0, 0, scaled(3));
  list.AddRect(low, high, palette::kAccent, 0, 0, std::max(1.0f, scaled(1)));
}

}  // namespace guidelight

#include "ui/tools/rectangle_tool.h"

#include <algorithm>

#include "ui/theme.h"
#include "ui/widgets.h"

namespace guidelight {

std::optional<PixelRegion> region_between(Vec2 a, Vec2 b, int width, int height) {
  const Vec2 size(width, height);
  const Vec2 low = glm::clamp(glm::floor(glm::min(a, b)), Vec2(0), size);
  const Vec2 high = glm::clamp(glm::ceil(glm::max(a, b)), Vec2(0), size);
  if (low.x >= high.x || low.y >= high.y) return std::nullopt;
  return PixelRegion{static_cast<int>(low.x), static_cast<int>(low.y), static_cast<int>(high.x),
                     static_cast<int>(high.y)};
}

void draw_outline(const PixelRegion& region, const ViewTransform& transform, ImDrawList& list) {
  const Vec2 low = transform.to_screen(Vec2(region.x0, region.y0));
  const Vec2 high = transform.to_screen(Vec2(region.x1, region.y1));
  const float thickness = std::max(1.0f, scaled(1));
  list.AddRect(to_imgui(low - 1.0f), to_imgui(high + 1.0f), IM_COL32(0, 0, 0, 180), 0, 0,
               thickness + 2);
  list.AddRect(to_imgui(low - 1.0f), to_imgui(high + 1.0f), palette::kAccent, 0, 0, thickness);
}

void RectangleTool::press(Document&, const ToolView& view) {
  if (!view.picture) return;
  from_ = to_ = view.picture->to_pixel(view.mouse);
  dragging_ = true;
}

void RectangleTool::drag(Document&, const ToolView& view) {
  if (view.picture) to_ = view.picture->to_pixel(view.mouse);
}

void RectangleTool::release(Document& document, const ToolView& view) {
  if (!dragging_) return;
  drag(document, view);
  dragging_ = false;
  finished_ = true;
  const RenderSettings& settings = document.settings();
  const bool dragged = glm::length(to_ - from_) >= 2;
  take_rectangle(document, dragged ? region_between(from_, to_, settings.width, settings.height)
                                   : std::nullopt);
}

bool RectangleTool::take(Document&, ToolCommand command) {
  if (command != ToolCommand::Cancel) return false;
  dragging_ = false;
  finished_ = true;
  return true;
}

void RectangleTool::draw(const Document& document, const ToolView& view, ImDrawList& list) const {
  if (!dragging_ || !view.picture) return;
  const RenderSettings& settings = document.settings();
  const auto rectangle = region_between(from_, to_, settings.width, settings.height);
  if (rectangle) draw_rectangle(document, *rectangle, *view.picture, list);
}

}  // namespace guidelight

#include "ui/tools/region_tool.h"

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

void draw_region(const PixelRegion& region, const RenderSettings& settings,
                 const ViewTransform& transform, ImDrawList& list) {
  const Vec2 outer_low = transform.to_screen(Vec2(0));
  const Vec2 outer_high = transform.to_screen(Vec2(settings.width, settings.height));
  const Vec2 low = transform.to_screen(Vec2(region.x0, region.y0));
  const Vec2 high = transform.to_screen(Vec2(region.x1, region.y1));
  constexpr ImU32 kShade = IM_COL32(0, 0, 0, 110);
  list.AddRectFilled(to_imgui(outer_low), {outer_high.x, low.y}, kShade);
  list.AddRectFilled({outer_low.x, high.y}, to_imgui(outer_high), kShade);
  list.AddRectFilled({outer_low.x, low.y}, {low.x, high.y}, kShade);
  list.AddRectFilled({high.x, low.y}, {outer_high.x, high.y}, kShade);
  list.AddRect(to_imgui(low - 1.0f), to_imgui(high + 1.0f), palette::kAccent, 0, 0,
               std::max(1.0f, scaled(1)));
}

void RegionTool::press(Document&, const ToolView& view) {
  if (!view.picture) return;
  from_ = to_ = view.picture->to_pixel(view.mouse);
  dragging_ = true;
}

void RegionTool::drag(Document&, const ToolView& view) {
  if (view.picture) to_ = view.picture->to_pixel(view.mouse);
}

void RegionTool::release(Document& document, const ToolView& view) {
  if (!dragging_) return;
  drag(document, view);
  dragging_ = false;
  finished_ = true;
  RenderSettings settings = document.settings();
  const bool dragged = glm::length(to_ - from_) >= 2;
  settings.region =
      dragged ? region_between(from_, to_, settings.width, settings.height) : std::nullopt;
  document.set_settings(settings);
}

void RegionTool::draw(const Document& document, const ToolView& view, ImDrawList& list) const {
  if (!dragging_ || !view.picture) return;
  const RenderSettings& settings = document.settings();
  if (const auto region = region_between(from_, to_, settings.width, settings.height)) {
    draw_region(*region, settings, *view.picture, list);
  }
}

}  // namespace guidelight

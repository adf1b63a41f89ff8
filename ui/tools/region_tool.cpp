#include "ui/tools/region_tool.h"

#include "ui/widgets.h"

namespace guidelight {

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
  draw_outline(region, transform, list);
}

void RegionTool::take_rectangle(Document& document, std::optional<PixelRegion> rectangle) {
  RenderSettings settings = document.settings();
  settings.region = rectangle;
  document.set_settings(settings);
}

void RegionTool::draw_rectangle(const Document& document, const PixelRegion& rectangle,
                                const ViewTransform& transform, ImDrawList& list) const {
  draw_region(rectangle, document.settings(), transform, list);
}

}  // namespace guidelight

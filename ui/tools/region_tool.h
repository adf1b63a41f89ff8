#pragma once

#include "ui/tools/rectangle_tool.h"

namespace guidelight {

/// Drags the rectangle that alone is rendered; a click without a drag renders the whole picture
/// again.
class RegionTool : public RectangleTool {
 public:
  std::string hint() const override { return "Drag a rectangle to render only that part"; }

 private:
  void take_rectangle(Document& document, std::optional<PixelRegion> rectangle) override;
  void draw_rectangle(const Document& document, const PixelRegion& rectangle,
                      const ViewTransform& transform, ImDrawList& list) const override;
};

/// The outline of a region, with what lies outside darkened.
void draw_region(const PixelRegion& region, const RenderSettings& settings,
                 const ViewTransform& transform, ImDrawList& list);

}  // namespace guidelight

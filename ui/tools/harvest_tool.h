#pragma once

#include "ui/tools/rectangle_tool.h"

namespace guidelight {

/// Drags the rectangle whose strongest light paths are looked for; a click without a drag asks
/// for those of the inspected pixel again.
class HarvestTool : public RectangleTool {
 public:
  std::string hint() const override {
    return "Drag a rectangle to see on which ways light reaches it";
  }

 private:
  void take_rectangle(Document& document, std::optional<PixelRegion> rectangle) override {
    document.view().harvested_region = rectangle;
  }
  void draw_rectangle(const Document&, const PixelRegion& rectangle, const ViewTransform& transform,
                      ImDrawList& list) const override {
    draw_outline(rectangle, transform, list);
  }
};

}  // namespace guidelight

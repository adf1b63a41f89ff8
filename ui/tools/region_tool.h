#pragma once

#include "ui/tools/tool.h"

namespace guidelight {

/// Drags the rectangle that alone is rendered; a click without a drag renders the whole picture
/// again.
class RegionTool : public Tool {
 public:
  std::string hint() const override { return "Drag a rectangle to render only that part"; }
  void press(Document& document, const ToolView& view) override;
  void drag(Document& document, const ToolView& view) override;
  void release(Document& document, const ToolView& view) override;
  bool finished() const override { return finished_; }
  void draw(const Document& document, const ToolView& view, ImDrawList& list) const override;

 private:
  Vec2 from_{0};
  Vec2 to_{0};
  bool dragging_ = false;
  bool finished_ = false;
};

/// The whole pixels that a rectangle touches, within a picture of this size; empty if there are
/// none.
std::optional<PixelRegion> region_between(Vec2 a, Vec2 b, int width, int height);

/// The outline of a region, with what lies outside darkened.
void draw_region(const PixelRegion& region, const RenderSettings& settings,
                 const ViewTransform& transform, ImDrawList& list);

}  // namespace guidelight

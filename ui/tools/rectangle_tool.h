#pragma once

#include "ui/tools/tool.h"

namespace guidelight {

/// Drags a rectangle of pixels over the picture and gives way to the default tool.
class RectangleTool : public Tool {
 public:
  void press(Document& document, const ToolView& view) override;
  void drag(Document& document, const ToolView& view) override;
  void release(Document& document, const ToolView& view) override;
  bool take(Document& document, ToolCommand command) override;
  bool finished() const override { return finished_; }
  void draw(const Document& document, const ToolView& view, ImDrawList& list) const override;

 protected:
  /// What the rectangle is for; empty after a click without a drag.
  virtual void take_rectangle(Document& document, std::optional<PixelRegion> rectangle) = 0;
  virtual void draw_rectangle(const Document& document, const PixelRegion& rectangle,
                              const ViewTransform& transform, ImDrawList& list) const = 0;

 private:
  Vec2 from_{0};
  Vec2 to_{0};
  bool dragging_ = false;
  bool finished_ = false;
};

/// The whole pixels that a rectangle touches, within a picture of this size; empty if there are
/// none.
std::optional<PixelRegion> region_between(Vec2 a, Vec2 b, int width, int height);

/// The outline of a region of the picture.
void draw_outline(const PixelRegion& region, const ViewTransform& transform, ImDrawList& list);

}  // namespace guidelight

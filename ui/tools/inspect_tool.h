#pragma once

#include "ui/tools/tool.h"

namespace guidelight {

/// Picks the pixel that the inspector shows; the default tool.
class InspectTool : public Tool {
 public:
  void press(Document& document, Vec2 pixel) override;
  void drag(Document& document, Vec2 pixel) override;
  void release(Document&, Vec2) override {}
  void draw(const Document& document, const ViewTransform& transform,
            ImDrawList& list) const override;
};

}  // namespace guidelight

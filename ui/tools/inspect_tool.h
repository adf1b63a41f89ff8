#pragma once

#include "ui/guides/vertex_drag.h"
#include "ui/tools/tool.h"

namespace guidelight {

/// Picks the pixel that the inspector shows, and drags vertices of guides; the default tool.
class InspectTool : public Tool {
 public:
  void hover(Document& document, const ToolView& view) override;
  void leave() override { vertex_drag_.leave(); }
  void press(Document& document, const ToolView& view) override;
  void drag(Document& document, const ToolView& view) override;
  void release(Document& document, const ToolView& view) override;
  void draw(const Document& document, const ToolView& view, ImDrawList& list) const override;

 private:
  void pick_pixel(Document& document, const ToolView& view) const;

  VertexDrag vertex_drag_;
};

}  // namespace guidelight

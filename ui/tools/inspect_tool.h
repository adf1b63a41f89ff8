#pragma once

#include "ui/tools/tool.h"

namespace guidelight {

/// Picks the pixel that the inspector shows; the default tool.
class InspectTool : public Tool {
 public:
  void press(Document& document, const ToolView& view) override;
  void drag(Document& document, const ToolView& view) override;
  void release(Document&, const ToolView&) override {}
  void draw(const Document& document, const ToolView& view, ImDrawList& list) const override;
};

}  // namespace guidelight

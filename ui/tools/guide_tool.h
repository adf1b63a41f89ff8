#pragma once

#include "ui/guides/guide_draft.h"
#include "ui/guides/vertex_drag.h"
#include "ui/tools/tool.h"

namespace guidelight {

/// Places a guide path: a click on a light, then on one surface after another. Dragging from the
/// light swings a ray whose whole path is traced. Vertices of other guides can be dragged while
/// none is being placed.
class GuideTool : public Tool {
 public:
  std::string hint() const override;
  void hover(Document& document, const ToolView& view) override;
  void leave() override;
  void press(Document& document, const ToolView& view) override;
  void drag(Document& document, const ToolView& view) override;
  void release(Document& document, const ToolView& view) override;
  bool take(Document& document, ToolCommand command) override;
  bool finished() const override { return finished_; }
  void draw(const Document& document, const ToolView& view, ImDrawList& list) const override;

 private:
  void press_light(Document& document, const ToolView& view);
  void swing(Document& document, const ToolView& view);
  void finish(Document& document);

  GuideDraft draft_;
  std::optional<Continuation> preview_;
  std::optional<LightPlace> hovered_light_;
  std::string problem_;  // with what was clicked last
  VertexDrag vertex_drag_;
  std::optional<Vec2> light_pressed_at_;  // on the screen, while the button is held
  bool finished_ = false;
};

}  // namespace guidelight

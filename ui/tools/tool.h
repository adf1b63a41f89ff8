#pragma once

#include <imgui.h>

#include <string>

#include "ui/document.h"
#include "ui/key_table.h"
#include "ui/view_projection.h"
#include "ui/view_transform.h"

namespace guidelight {

/// The view that a tool works in, and the mouse over it.
struct ToolView {
  const ViewProjection& projection;
  const ViewTransform* picture;  // null in views that do not show the picture
  /// Points with dot(clip_plane, (p, 1)) < 0 are not shown.
  Vec4 clip_plane{0, 0, 0, 1};
  bool sees_through = false;  // nothing hides anything
  Vec2 mouse{0};              // on the screen [pixels]
  bool hovered = false;       // the mouse is over this view
  bool double_click = false;  // of the left button, in this frame
};

/// What the view shows at a position of its screen: through its clip plane, if there is one.
Ray pick_ray(const ToolView& view, Vec2 screen);
std::optional<SurfacePoint> pick_surface(const Scene& scene, const ToolView& view);

/// What the left button does in the views.
class Tool {
 public:
  virtual ~Tool() = default;

  /// One line that says what to do, shown over the view; empty for none.
  virtual std::string hint() const { return ""; }
  /// The mouse rests or moves over the view with no button down.
  virtual void hover(Document&, const ToolView&) {}
  virtual void leave() {}
  virtual void press(Document& document, const ToolView& view) = 0;
  virtual void drag(Document& document, const ToolView& view) = 0;
  virtual void release(Document& document, const ToolView& view) = 0;
  /// False for commands that mean nothing to the tool at the moment.
  virtual bool take(Document&, ToolCommand) { return false; }
  /// Whether the tool has done its work and gives way to the default one.
  virtual bool finished() const { return false; }
  /// Marks over the view.
  virtual void draw(const Document& document, const ToolView& view, ImDrawList& list) const = 0;
};

}  // namespace guidelight

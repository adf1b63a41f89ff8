#pragma once

#include <imgui.h>

#include "ui/document.h"
#include "ui/view_transform.h"

namespace guidelight {

/// What the left button does in the picture. Positions are in pixels of the full-size picture and
/// may lie outside of it.
class Tool {
 public:
  virtual ~Tool() = default;

  /// One line that says what to do, shown over the picture; empty for none.
  virtual const char* hint() const { return ""; }
  virtual void press(Document& document, Vec2 pixel) = 0;
  virtual void drag(Document& document, Vec2 pixel) = 0;
  virtual void release(Document& document, Vec2 pixel) = 0;
  /// Whether the tool has done its work and gives way to the default one.
  virtual bool finished() const { return false; }
  /// Marks over the picture.
  virtual void draw(const Document& document, const ViewTransform& transform,
                    ImDrawList& list) const = 0;
};

}  // namespace guidelight

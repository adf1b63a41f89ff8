#pragma once

#include <optional>

#include "ui/tools/tool.h"

namespace guidelight {

/// A vertex of a guide that the mouse can take hold of.
struct GuideHandle {
  size_t guide;
  int vertex;
  bool operator==(const GuideHandle&) const = default;
};

/// Taking a vertex of a guide by the mouse and putting it elsewhere; part of every tool that lets
/// guides be edited.
class VertexDrag {
 public:
  /// Finds the vertex under the mouse.
  void hover(const Document& document, const ToolView& view);
  void leave() { handle_.reset(); }
  /// Takes hold of the vertex under the mouse and selects its guide; false if there is none.
  bool press(Document& document, const ToolView& view);
  bool active() const { return active_; }
  void drag(Document& document, const ToolView& view);
  void release(Document& document);

  /// Marks the vertex under the mouse.
  void draw(const Document& document, const ToolView& view, ImDrawList& list) const;

 private:
  std::optional<GuideHandle> handle_;
  GuideList guides_;  // as the drag left them: a change from elsewhere ends it
  bool active_ = false;
};

}  // namespace guidelight

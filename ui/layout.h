#pragma once

#include <imgui.h>

namespace guidelight {

/// A rectangle of the window [pixels].
struct Area {
  ImVec2 corner;
  ImVec2 size;
};

/// Where things are: a menu bar above, a status bar below, a column of panels on either side of the
/// view, with borders that can be dragged.
class Layout {
 public:
  /// Of each column of panels as the window opens, at scale 1.
  static constexpr float kColumnWidth = 308;

  /// Computes the areas for the window as it is now, lets the borders be dragged and draws them.
  void update(bool panels_shown, float menu_height);

  const Area& left() const { return left_; }
  const Area& view() const { return view_; }
  const Area& right() const { return right_; }
  const Area& status() const { return status_; }

 private:
  void drag_border(const char* name, float x, float& width, float direction);

  float left_width_ = kColumnWidth;  // at scale 1
  float right_width_ = kColumnWidth;
  Area left_, view_, right_, status_;
};

/// A border at x, relative to the area, that can be dragged: draws it and returns how far it was
/// moved in this frame [pixels].
float drag_vertical_border(const char* name, const Area& area, float x);

/// The room between the edge of an area and what is in it. Only panels scroll.
enum class Padding { None, Bar, Panel };

/// Begins a fixed ImGui window that fills an area. End it with ImGui::End().
void begin_area(const char* name, const Area& area, Padding padding, ImU32 background);

}  // namespace guidelight

#pragma once

#include "ui/layout.h"

namespace guidelight {

enum class ShownViews { Render, Scout, Both };

/// Divides the room for views among those that are shown, with a border to drag between two.
class ViewLayout {
 public:
  ShownViews shown() const { return shown_; }
  void show(ShownViews views) { shown_ = views; }
  /// Render, scout, both, render …
  void cycle();
  bool shows_render() const { return shown_ != ShownViews::Scout; }
  bool shows_scout() const { return shown_ != ShownViews::Render; }

  void update(const Area& room);
  const Area& render() const { return render_; }
  const Area& scout() const { return scout_; }

  /// The three buttons, at the right end of the menu bar.
  void draw_buttons();

 private:
  ShownViews shown_ = ShownViews::Render;
  float render_share_ = 0.5f;
  Area render_, scout_;
};

}  // namespace guidelight

#pragma once

#include <imgui.h>

#include <span>

#include "ui/tools/tool.h"

namespace guidelight {

/// Draws lines and marks of the world over a view. What the scene hides is faded; whether it does
/// is found by tracing rays, so that it is exact in every view.
class WorldPainter {
 public:
  WorldPainter(const Scene& scene, const ToolView& view, ImDrawList& list)
      : scene_(scene), view_(view), list_(list) {}

  void line(Vec3 a, Vec3 b, ImU32 color, float thickness);
  void polyline(std::span<const Vec3> points, ImU32 color, float thickness);
  /// Around the center, across the unit normal.
  void circle(Vec3 center, Vec3 normal, float radius, ImU32 color, float thickness);
  /// Radii in pixels; a dark rim keeps it apart from any picture.
  void dot(Vec3 center, ImU32 color, float radius);
  /// A circle on the screen.
  void ring(Vec3 center, ImU32 color, float radius, float thickness);

  bool visible(Vec3 point) const;

 private:
  Ray sight_line(Vec3 point) const;

  const Scene& scene_;
  const ToolView& view_;
  ImDrawList& list_;
};

}  // namespace guidelight

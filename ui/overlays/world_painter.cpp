#include "ui/overlays/world_painter.h"

#include <algorithm>
#include <array>
#include <vector>

#include "renderer/math/frame.h"
#include "ui/widgets.h"

namespace guidelight {
namespace {

constexpr float kShade = 0.4f;    // opacity of the dark rim that keeps lines apart from any picture
constexpr float kHidden = 0.28f;  // opacity of what is hidden
constexpr float kPixelsPerPiece = 10;  // of a line that is drawn as visible or hidden
constexpr int kMostPieces = 64;
constexpr float kShortOfThePoint = 1e-3f;  // marks lie on surfaces, which must not hide them

}  // namespace

/// From the point towards the eye, as far as the view shows anything.
Ray WorldPainter::sight_line(Vec3 point) const {
  const Vec3 way = view_.projection.seen_from(point) - point;
  Ray ray{point + kShortOfThePoint * way, (1 - kShortOfThePoint) * way, 1};
  const float side_here = glm::dot(view_.clip_plane, Vec4(point, 1));
  const float side_there = glm::dot(view_.clip_plane, Vec4(point + way, 1));
  if (side_here > 0 && side_there < 0) ray.t_max = side_here / (side_here - side_there);
  return ray;
}

bool WorldPainter::visible(Vec3 point) const {
  return view_.sees_through || !scene_.occluded(sight_line(point));
}

void WorldPainter::line(Vec3 a, Vec3 b, ImU32 color, float thickness) {
  const auto seen = view_.projection.to_screen(a, b);
  if (!seen) return;
  const float length = glm::length(seen->b - seen->a);
  const int pieces = std::clamp(static_cast<int>(length / scaled(kPixelsPerPiece)), 1, kMostPieces);
  std::array<Ray, kMostPieces> rays;
  std::array<uint8_t, kMostPieces> hidden{};
  const auto share = [&](float i) {
    return glm::mix(seen->from, seen->to, i / static_cast<float>(pieces));
  };
  const auto point = [&](float i) { return glm::mix(a, b, share(i)); };
  if (!view_.sees_through) {
    for (int i = 0; i < pieces; ++i) {
      rays[i] = sight_line(point(static_cast<float>(i) + 0.5f));
    }
    const auto count = static_cast<size_t>(pieces);
    scene_.occluded({rays.data(), count}, {hidden.data(), count});
  }
  const auto draw = [&](int from, int to, bool is_hidden) {
    const auto p = view_.projection.to_screen(point(static_cast<float>(from)));
    const auto q = view_.projection.to_screen(point(static_cast<float>(to)));
    const ImVec2 begin = to_imgui(from == 0 || !p ? seen->a : *p);
    const ImVec2 end = to_imgui(to == pieces || !q ? seen->b : *q);
    const ImU32 shade = (color & IM_COL32_A_MASK) | IM_COL32(0, 0, 0, 0);
    if (!is_hidden) list_.AddLine(begin, end, faded(shade, kShade), thickness + scaled(1.5f));
    list_.AddLine(begin, end, is_hidden ? faded(color, kHidden) : color, thickness);
  };
  int begin = 0;
  for (int i = 1; i <= pieces; ++i) {
    if (i < pieces && hidden[i] == hidden[begin]) continue;
    draw(begin, i, hidden[begin]);
    begin = i;
  }
}

void WorldPainter::polyline(std::span<const Vec3> points, ImU32 color, float thickness) {
  for (size_t i = 1; i < points.size(); ++i) line(points[i - 1], points[i], color, thickness);
}

void WorldPainter::circle(Vec3 center, Vec3 normal, float radius, ImU32 color, float thickness) {
  constexpr int kSides = 24;
  const Frame frame = Frame::from_normal(normal);
  std::array<Vec3, kSides + 1> points;
  for (int i = 0; i <= kSides; ++i) {
    const float angle = 2 * kPi * static_cast<float>(i) / kSides;
    points[i] = center + radius * (std::cos(angle) * frame.s + std::sin(angle) * frame.t);
  }
  polyline(points, color, thickness);
}

void WorldPainter::dot(Vec3 center, ImU32 color, float radius) {
  const auto screen = view_.projection.to_screen(center);
  if (!screen) return;
  const float opacity = visible(center) ? 1 : kHidden;
  list_.AddCircleFilled(to_imgui(*screen), radius + scaled(1.5f),
                        faded(IM_COL32(0, 0, 0, 170), opacity));
  list_.AddCircleFilled(to_imgui(*screen), radius, faded(color, opacity));
}

void WorldPainter::ring(Vec3 center, ImU32 color, float radius, float thickness) {
  const auto screen = view_.projection.to_screen(center);
  if (!screen) return;
  const float opacity = visible(center) ? 1 : kHidden;
  list_.AddCircle(to_imgui(*screen), radius, faded(color, opacity), 0, thickness);
}

}  // namespace guidelight

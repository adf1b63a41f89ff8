#include "ui/overlays/guide_overlay.h"

#include <algorithm>

#include "renderer/math/frame.h"
#include "ui/overlays/world_painter.h"
#include "ui/theme.h"
#include "ui/tools/rectangle_tool.h"
#include "ui/widgets.h"

namespace guidelight {
namespace {

constexpr float kConeShare = 0.4f;   // of the segment that a cone is drawn along
constexpr float kWidestCone = 1.3f;  // [rad] that is drawn to scale
constexpr size_t kCandidatesDrawn = 24;
constexpr ImU32 kBackdrop = IM_COL32(0, 0, 0, 90);
constexpr float kOffOpacity = 0.35f;  // of a guide that is switched off

/// One guide over one view.
class GuideDrawing {
 public:
  GuideDrawing(const Document& document, size_t guide, const ToolView& view, ImDrawList& list)
      : document_(document),
        guide_((*document.guides())[guide]),
        view_(view),
        list_(list),
        painter_(document.scene(), view, list),
        selected_(document.guide_view().selected == guide) {
    const auto& solo = document.guide_view().solo;
    const bool followed = solo ? *solo == guide : guide_.enabled;
    color_ = to_imgui_color(guide_.color, followed ? 1 : kOffOpacity);
    const auto& faults = document.guide_faults(guide);
    if (!faults.empty()) fault_ = &faults.front();
  }

  void draw() {
    if (selected_ && document_.guide_view().candidates_shown) draw_candidates();
    if (selected_) draw_cones();
    draw_path();
    if (selected_ && fault_) draw_reason();
  }

  void draw_path() {
    const float thickness = scaled(selected_ ? 3.0f : 1.75f);
    for (int i = 1; i < count(); ++i) {
      const bool faulty = fault_ && i == fault_->vertex;
      const bool behind_fault = fault_ && i > fault_->vertex;
      const ImU32 color = faulty ? palette::kError : behind_fault ? faded(color_, 0.5f) : color_;
      painter_.line(at(i - 1), at(i), color, thickness);
    }
    for (int i = 0; i < count(); ++i) {
      const bool faulty = fault_ && i == fault_->vertex;
      const bool specular =
          i > 0 && i + 1 < count() && guide_.vertices[i].event != PathEvent::Scatter;
      const float radius = scaled((specular ? 2.5f : 4.0f) + (selected_ ? 1.0f : 0.0f));
      painter_.dot(at(i), faulty ? palette::kError : color_, radius);
    }
  }

 private:
  int count() const { return static_cast<int>(guide_.vertices.size()); }
  Vec3 at(int i) const { return guide_.vertices[i].position; }

  void draw_candidates() {
    const auto& candidates = document_.candidates().candidates;
    for (size_t i = 0; i < std::min(candidates.size(), kCandidatesDrawn); ++i) {
      const ImU32 color = candidates[i].valid ? faded(color_, 0.35f) : faded(palette::kError, 0.3f);
      const auto& points = candidates[i].points;
      for (size_t j = 1; j < points.size(); ++j) {
        const auto line = view_.projection.to_screen(points[j - 1], points[j]);
        if (line) list_.AddLine(to_imgui(line->a), to_imgui(line->b), color, 1);
      }
    }
  }

  void draw_cones() {
    for (int i = 0; i + 1 < count(); ++i) {
      const GuideVertex& vertex = guide_.vertices[i];
      const Vec3 way = at(i + 1) - at(i);
      if (vertex.event != PathEvent::Scatter || !(glm::length(way) > 0)) continue;
      draw_cone(at(i), kConeShare * way, std::min(vertex.cone, kWidestCone));
      if (i == 0) painter_.circle(at(0), glm::normalize(way), guide_.disc_radius, color_, 1);
    }
  }

  void draw_cone(Vec3 apex, Vec3 axis, float angle) {
    constexpr int kEdges = 6;
    const float length = glm::length(axis);
    const Frame frame = Frame::from_normal(axis / length);
    const float radius = length * std::tan(angle);
    const ImU32 color = faded(color_, 0.5f);
    painter_.circle(apex + axis, frame.n, radius, color, scaled(1));
    for (int i = 0; i < kEdges; ++i) {
      const float turn = 2 * kPi * static_cast<float>(i) / kEdges;
      const Vec3 rim = std::cos(turn) * frame.s + std::sin(turn) * frame.t;
      painter_.line(apex, apex + axis + radius * rim, faded(color, 0.6f), scaled(1));
    }
  }

  void draw_reason() {
    const auto place = view_.projection.to_screen(at(std::clamp(fault_->vertex, 0, count() - 1)));
    if (!place) return;
    draw_note(list_, *place + Vec2(scaled(14), scaled(10)), fault_->message,
              IM_COL32(60, 18, 16, 230), IM_COL32(255, 214, 210, 255));
  }

  const Document& document_;
  const GuidePath& guide_;
  const ToolView& view_;
  ImDrawList& list_;
  WorldPainter painter_;
  bool selected_;
  ImU32 color_ = 0;
  const GuideFault* fault_ = nullptr;
};

}  // namespace

void draw_guides(const Document& document, const ToolView& view, ImDrawList& list) {
  if (!document.guide_view().shown) return;
  const size_t count = document.guides()->size();
  const auto& selected = document.guide_view().selected;
  for (size_t i = 0; i < count; ++i) {
    if (selected != i) GuideDrawing(document, i, view, list).draw();
  }
  if (selected) GuideDrawing(document, *selected, view, list).draw();
}

void draw_plain_guide(const Document& document, size_t guide, const ToolView& view,
                      ImDrawList& list) {
  GuideDrawing(document, guide, view, list).draw_path();
}

void draw_harvest(const Document& document, const ToolView& view, ImDrawList& list) {
  const Harvest& harvest = document.harvest();
  const bool is_rectangle = harvest.region && harvest.region == document.view().harvested_region;
  if (is_rectangle && view.picture) draw_outline(*harvest.region, *view.picture, list);
  WorldPainter painter(document.scene(), view, list);
  for (size_t i = 0; i < harvest.paths.size(); ++i) {
    const bool selected = harvest.selected == i;
    const ImU32 color = selected ? palette::kText : faded(palette::kText, 0.6f);
    std::vector<Vec3> points;
    for (const GuideVertex& vertex : harvest.paths[i].guide.vertices) {
      points.push_back(vertex.position);
    }
    const float thickness = scaled(selected ? 2.5f : 1.0f);
    painter.polyline(points, kBackdrop, thickness + scaled(2));  // against a bright picture
    painter.polyline(points, color, thickness);
    for (const Vec3 point : points) painter.dot(point, color, scaled(selected ? 3.5f : 2.0f));
  }
}

}  // namespace guidelight

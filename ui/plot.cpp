#include "ui/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ui/format.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace guidelight {
namespace {

constexpr float kPlotHeight = 92;  // at scale 1

/// Where values lie along one axis.
class PlotRange {
 public:
  explicit PlotRange(bool logarithmic) : logarithmic_(logarithmic) {}

  bool shows(float value) const { return std::isfinite(value) && (!logarithmic_ || value > 0); }
  void extend(float value) {
    if (!shows(value)) return;
    low_ = std::min(low_, position(value));
    high_ = std::max(high_, position(value));
  }
  bool empty() const { return !(low_ <= high_); }
  /// 0 … 1 from the lower to the upper end.
  float share(float value) const {
    return high_ > low_ ? (position(value) - low_) / (high_ - low_) : 0.5f;
  }
  float low() const { return value(low_); }
  float high() const { return value(high_); }

 private:
  float position(float x) const { return logarithmic_ ? std::log(x) : x; }
  float value(float x) const { return logarithmic_ ? std::exp(x) : x; }

  bool logarithmic_;
  float low_ = kInfinity;
  float high_ = -kInfinity;
};

std::string with_plot_unit(float value, const std::string& unit) {
  const std::string number = fmt::format("{:.3g}", value);
  return unit.empty() ? number : number + " " + unit;
}

void draw_curve_legend(std::span<const PlotCurve> curves) {
  for (const PlotCurve& curve : curves) {
    if (curve.name.empty()) continue;
    const Vec2 corner = from_imgui(ImGui::GetCursorScreenPos());
    const float line = ImGui::GetTextLineHeight();
    ImGui::GetWindowDrawList()->AddLine(to_imgui(corner + Vec2(0, line / 2)),
                                        to_imgui(corner + Vec2(scaled(12), line / 2)), curve.color,
                                        scaled(2));
    ImGui::Dummy({scaled(14), line});
    ImGui::SameLine(0, scaled(5));
    dim_text(shortened(curve.name, ImGui::GetContentRegionAvail().x));
  }
}

struct PlotRanges {
  PlotRange x;
  PlotRange y;
  bool show(Vec2 point) const { return x.shows(point.x) && y.shows(point.y); }
};

PlotRanges ranges_of(std::span<const PlotCurve> curves, const PlotAxes& axes) {
  PlotRanges ranges{PlotRange(axes.logarithmic_x), PlotRange(axes.logarithmic_y)};
  for (const PlotCurve& curve : curves) {
    for (const Vec2 point : curve.points) {
      if (!ranges.show(point)) continue;
      ranges.x.extend(point.x);
      ranges.y.extend(point.y);
    }
  }
  return ranges;
}

/// By x; null for a curve without points that can be shown.
const Vec2* nearest_point(const PlotCurve& curve, const PlotRanges& ranges, float x_share) {
  const Vec2* nearest = nullptr;
  const auto distance = [&](Vec2 point) { return std::abs(ranges.x.share(point.x) - x_share); };
  for (const Vec2& point : curve.points) {
    if (!ranges.show(point)) continue;
    if (!nearest || distance(point) < distance(*nearest)) nearest = &point;
  }
  return nearest;
}

}  // namespace

std::string plot_values(std::span<const PlotCurve> curves, const PlotAxes& axes, float x_share) {
  const PlotRanges ranges = ranges_of(curves, axes);
  std::string text;
  for (const PlotCurve& curve : curves) {
    const Vec2* point = nearest_point(curve, ranges, x_share);
    if (!point) continue;
    if (!text.empty()) text += "\n";
    if (!curve.name.empty()) text += curve.name + ": ";
    text += with_plot_unit(point->y, axes.y_unit) + " at " + with_plot_unit(point->x, axes.x_unit);
  }
  return text;
}

void draw_plot(const char* id, std::span<const PlotCurve> curves, const PlotAxes& axes) {
  const PlotRanges ranges = ranges_of(curves, axes);
  const auto& [x, y] = ranges;
  const Vec2 corner = from_imgui(ImGui::GetCursorScreenPos());
  const Vec2 size(std::max(1.0f, ImGui::GetContentRegionAvail().x), scaled(kPlotHeight));
  ImGui::InvisibleButton(id, to_imgui(size));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(to_imgui(corner), to_imgui(corner + size), palette::kBackdrop, scaled(4));
  if (x.empty()) {
    centered_text(list, corner + 0.5f * size, palette::kDim, "nothing yet");
    return;
  }
  const float margin = scaled(7);
  const float mouse = (ImGui::GetMousePos().x - corner.x - margin) / (size.x - 2 * margin);
  if (ImGui::IsItemHovered()) tooltip(plot_values(curves, axes, mouse));
  const auto place = [&](Vec2 point) {
    const Vec2 share(x.share(point.x), 1 - y.share(point.y));
    return corner + margin + share * (size - 2 * margin);
  };
  for (const PlotCurve& curve : curves) {
    std::vector<ImVec2> line;
    for (const Vec2 point : curve.points) {
      if (ranges.show(point)) line.push_back(to_imgui(place(point)));
    }
    if (line.size() == 1) list.AddCircleFilled(line[0], scaled(2), curve.color);
    list.AddPolyline(line.data(), static_cast<int>(line.size()), curve.color, 0, scaled(1.5f));
  }
  const float small = 0.85f * ImGui::GetFontSize();
  const auto corner_text = [&](Vec2 at, const std::string& text, bool right) {
    const Vec2 extent =
        from_imgui(ImGui::GetFont()->CalcTextSizeA(small, FLT_MAX, 0, text.c_str()));
    if (right) at.x -= extent.x;
    // Curves pass below.
    list.AddRectFilled(to_imgui(at - scaled(2)), to_imgui(at + extent + scaled(2)),
                       faded(palette::kBackdrop, 0.8f), scaled(2));
    list.AddText(ImGui::GetFont(), small, to_imgui(at), palette::kDim, text.c_str());
  };
  const float pad = scaled(5);
  corner_text(corner + Vec2(pad, scaled(3)), with_plot_unit(y.high(), axes.y_unit), false);
  corner_text(corner + Vec2(pad, size.y - small - scaled(3)), with_plot_unit(y.low(), axes.y_unit),
              false);
  corner_text(corner + size - Vec2(pad, small + scaled(3)), with_plot_unit(x.high(), axes.x_unit),
              true);
  draw_curve_legend(curves);
}

}  // namespace guidelight

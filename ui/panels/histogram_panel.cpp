#include <fmt/format.h>

#include <cmath>

#include "ui/format.h"
#include "ui/panels/panels.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace guidelight {
namespace {

constexpr ImU32 kChannelColors[3] = {IM_COL32(214, 92, 84, 130), IM_COL32(104, 186, 110, 130),
                                     IM_COL32(92, 140, 224, 130)};

/// Where a value in EV lies between the left (0) and the right (1) of the histogram.
float position_of(float ev) {
  return (ev - Histogram::kMinEv) / (Histogram::kMaxEv - Histogram::kMinEv);
}

void draw_bars(ImDrawList& list, const Histogram& histogram, Vec2 corner, Vec2 size) {
  if (histogram.tallest == 0) return;
  const float bar = size.x / Histogram::kBins;
  for (int channel = 0; channel < 3; ++channel) {
    for (int bin = 0; bin < Histogram::kBins; ++bin) {
      const float share = static_cast<float>(histogram.counts[channel][bin]) /
                          static_cast<float>(histogram.tallest);
      if (share == 0) continue;
      // The square root keeps rare values visible beside frequent ones.
      const Vec2 low = corner + Vec2(bar * bin, size.y * (1 - std::sqrt(share)));
      list.AddRectFilled(to_imgui(low), to_imgui(corner + Vec2(bar * (bin + 1), size.y)),
                         kChannelColors[channel]);
    }
  }
}

void draw_axis(ImDrawList& list, Vec2 corner, Vec2 size) {
  for (int ev = -8; ev <= 8; ev += 4) {
    const float x = std::round(corner.x + position_of(static_cast<float>(ev)) * size.x);
    list.AddLine({x, corner.y}, {x, corner.y + size.y}, IM_COL32(255, 255, 255, 22));
    const std::string label = ev == 0 ? "0 EV" : fmt::format("{:+}", ev);
    const float width = ImGui::CalcTextSize(label.c_str()).x;
    list.AddText({x - width / 2, corner.y + size.y + scaled(3)}, palette::kDim, label.c_str());
  }
}

/// The value that the exposure shows as white.
void draw_white_marker(ImDrawList& list, float exposure, Vec2 corner, Vec2 size) {
  const float share = position_of(-exposure);
  if (share < 0 || share > 1) return;
  const float x = std::round(corner.x + share * size.x);
  list.AddLine({x, corner.y}, {x, corner.y + size.y}, palette::kAccent, scaled(1));
  list.AddText({x + scaled(4), corner.y + scaled(2)}, palette::kAccent, "white");
}

}  // namespace

void draw_histogram_panel(const Document& document, const Picture* picture) {
  if (!section("Histogram")) return;
  const Vec2 corner = from_imgui(ImGui::GetCursorScreenPos());
  const Vec2 size(ImGui::GetContentRegionAvail().x, scaled(84));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(to_imgui(corner), to_imgui(corner + size), palette::kBackdrop, scaled(5));
  if (picture) draw_bars(list, picture->histogram, corner, size);
  draw_axis(list, corner, size);
  const DisplaySettings& display = document.view().current();
  if (display.curve != ToneCurve::FalseColor) {
    draw_white_marker(list, display.exposure, corner, size);
  }
  ImGui::Dummy({size.x, size.y + ImGui::GetTextLineHeight() + scaled(3)});
  tooltip("How often each linear value occurs, per channel; both axes are compressed.");
  if (!picture) return;
  const auto pixels = static_cast<double>(picture->snapshot->layer(picture->layer).pixel_count());
  readout("Black", format_percent(static_cast<double>(picture->histogram.zero) / pixels));
  const uint64_t broken = picture->histogram.not_finite + picture->snapshot->rejected_samples;
  if (broken > 0) {
    readout("Not finite", format_count(static_cast<double>(broken)),
            "Samples that were NaN or infinite and count as black, and such pixels");
  }
}

}  // namespace guidelight

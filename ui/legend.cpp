#include "ui/legend.h"

#include <cmath>

#include "ui/format.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace guidelight {
namespace {

constexpr int kSteps = 64;
constexpr int kTicks = 5;
constexpr int kMostDecades = 6;

/// At the powers of ten if both ends are, else evenly.
int ticks_between(float low, float high) {
  const float decades = std::log10(high / low);
  const auto whole = static_cast<int>(std::round(decades));
  const bool is_whole = std::abs(decades - static_cast<float>(whole)) < 1e-3f;
  return is_whole && whole >= 2 && whole <= kMostDecades ? whole + 1 : kTicks;
}

}  // namespace

const char* layer_unit(Layer layer) {
  switch (layer) {
    case Layer::Beauty:
    case Layer::Direct:
    case Layer::Indirect:
    case Layer::Caustic:
    case Layer::Connection:
    case Layer::Merging:
      return "W/(m² sr)";
    case Layer::Variance:
      return "(W/(m² sr))²";
    case Layer::Depth:
      return "scene units";
    case Layer::SampleCount:
      return "samples";
    case Layer::Albedo:
    case Layer::Normal:
      return "";
  }
  return "";
}

const char* layer_label(Layer layer) {
  switch (layer) {
    case Layer::Beauty:
      return "Beauty";
    case Layer::Direct:
      return "Direct light";
    case Layer::Indirect:
      return "Indirect light";
    case Layer::Caustic:
      return "Caustics";
    case Layer::Connection:
      return "Connections";
    case Layer::Merging:
      return "Merging";
    case Layer::Albedo:
      return "Albedo";
    case Layer::Normal:
      return "Normal";
    case Layer::Depth:
      return "Depth";
    case Layer::SampleCount:
      return "Sample count";
    case Layer::Variance:
      return "Variance";
  }
  return "";
}

float draw_legend(ImDrawList& list, Vec2 corner, const Picture& picture) {
  const DisplaySettings& display = picture.display;
  // Values are multiplied by the exposure before they are mapped, so the scale is divided by it.
  const float gain = std::exp2(display.exposure);
  return draw_color_scale(list, corner,
                          {display.color_map, display.false_color_min / gain,
                           display.false_color_max / gain, layer_unit(picture.layer)});
}

float draw_color_scale(ImDrawList& list, Vec2 corner, const ColorScale& scale) {
  const char* unit = scale.heading.c_str();
  const int ticks = ticks_between(scale.low, scale.high);
  std::vector<std::string> labels(ticks);
  float widest = ImGui::CalcTextSize(unit).x - scaled(24);
  for (int tick = 0; tick < ticks; ++tick) {
    const float t = static_cast<float>(tick) / static_cast<float>(ticks - 1);
    labels[tick] = format_value(scale.low * std::pow(scale.high / scale.low, t));
    widest = std::max(widest, ImGui::CalcTextSize(labels[tick].c_str()).x);
  }
  const float line = ImGui::GetTextLineHeight();
  const Vec2 bar_size(scaled(14), scaled(170));
  const Vec2 padding(scaled(12), scaled(10));
  const Vec2 size =
      Vec2(bar_size.x + scaled(10) + widest, bar_size.y + 2.25f * line) + 2.0f * padding;
  const Vec2 low_corner = corner - size - scaled(12);
  list.AddRectFilled(to_imgui(low_corner), to_imgui(low_corner + size), IM_COL32(20, 20, 20, 215),
                     scaled(6));
  const Vec2 top = low_corner + padding;
  list.AddText(to_imgui(top), palette::kDim, unit);

  const Vec2 bar = top + Vec2(0, 1.75f * line);
  for (int step = 0; step < kSteps; ++step) {
    const float from = static_cast<float>(step) / kSteps;
    const float to = static_cast<float>(step + 1) / kSteps;
    list.AddRectFilled(to_imgui(bar + Vec2(0, bar_size.y * (1 - to))),
                       to_imgui(bar + Vec2(bar_size.x, bar_size.y * (1 - from))),
                       to_imgui_color(color_map(scale.map, (from + to) / 2)));
  }
  for (int tick = 0; tick < ticks; ++tick) {
    const float y = bar_size.y * (1 - static_cast<float>(tick) / static_cast<float>(ticks - 1));
    list.AddText(to_imgui(bar + Vec2(bar_size.x + scaled(10), y - line / 2)), palette::kText,
                 labels[tick].c_str());
  }
  return size.x + scaled(12);
}

}  // namespace guidelight

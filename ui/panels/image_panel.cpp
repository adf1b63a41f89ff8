#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "ui/legend.h"
#include "ui/panels/panels.h"
#include "ui/widgets.h"

namespace guidelight {
namespace {

constexpr std::array kCurveLabels = {"sRGB", "Gamma", "Reinhard 2002", "Filmic", "False colour"};
constexpr std::array kMapLabels = {"Viridis", "Turbo", "Magma"};

std::string with_keys(const std::string& text, Action first, Action second) {
  return text + " (" + shortcut_text(first) + ", " + shortcut_text(second) + ")";
}

void draw_layer_choice(Document& document) {
  row("Layer", with_keys("What is shown", Action::PreviousLayer, Action::NextLayer));
  if (!ImGui::BeginCombo("##layer", layer_label(document.view().layer),
                         ImGuiComboFlags_HeightLarge)) {
    return;
  }
  for (const Layer layer : kAllLayers) {
    const bool chosen = layer == document.view().layer;
    if (ImGui::Selectable(layer_label(layer), chosen)) document.show_layer(layer);
  }
  ImGui::EndCombo();
}

void draw_exposure(DisplaySettings& display, const Perform& perform) {
  row("Exposure", with_keys("Values are multiplied by 2 to the power of this", Action::ExposureUp,
                            Action::ExposureDown));
  const float auto_width = ImGui::CalcTextSize("Auto").x + 2 * ImGui::GetStyle().FramePadding.x;
  const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - auto_width - gap);
  ImGui::SliderFloat("##exposure", &display.exposure, -kLargestExposure, kLargestExposure,
                     "%+.2f EV", ImGuiSliderFlags_AlwaysClamp);
  ImGui::SameLine(0, gap);
  if (ImGui::Button("Auto")) perform(Action::NormaliseExposure);
  tooltip(fmt::format("{} ({})", action_label(Action::NormaliseExposure),
                      shortcut_text(Action::NormaliseExposure)));
}

template <typename Enum, size_t N>
void draw_choice(const char* label, const char* id, const std::string& help, Enum& value,
                 const std::array<const char*, N>& names) {
  row(label, help);
  int index = static_cast<int>(value);
  if (ImGui::Combo(id, &index, names.data(), N)) value = static_cast<Enum>(index);
}

void draw_false_color(Layer layer, DisplaySettings& display) {
  draw_choice("Colours", "##map", "The colours that stand for values, dark to bright",
              display.color_map, kMapLabels);
  const std::string unit = layer_unit(layer);
  const std::string in_unit = unit.empty() ? "" : " [" + unit + "]";
  row("From", "The value shown in the first colour" + in_unit + "; the scale is logarithmic");
  number("##low", display.false_color_min, 1e-8f, 1e8f, "", true);
  row("To", "The value shown in the last colour" + in_unit);
  number("##high", display.false_color_max, 1e-8f, 1e8f, "", true);
  display.false_color_max = std::max(display.false_color_max, 1.001f * display.false_color_min);
}

void draw_curve_parameters(Layer layer, DisplaySettings& display) {
  switch (display.curve) {
    case ToneCurve::Gamma:
      row("Gamma", "Values are shown to the power of 1/gamma");
      ImGui::SliderFloat("##gamma", &display.gamma, 0.5f, 4, "%.2f", ImGuiSliderFlags_AlwaysClamp);
      break;
    case ToneCurve::Reinhard:
      row("White", "The smallest luminance that is shown as white");
      ImGui::SliderFloat("##white", &display.reinhard_white, 0.5f, 1000, "%.4g",
                         ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp);
      break;
    case ToneCurve::FalseColor:
      draw_false_color(layer, display);
      break;
    case ToneCurve::Srgb:
    case ToneCurve::Filmic:
      break;
  }
}

}  // namespace

void draw_image_panel(Document& document, const Perform& perform) {
  if (!section("Image")) return;
  draw_layer_choice(document);
  DisplaySettings& display = document.view().current();
  draw_exposure(display, perform);
  draw_choice("Tone", "##tone", "From linear values to the screen", display.curve, kCurveLabels);
  draw_curve_parameters(document.view().layer, display);
  row("Clipping",
      fmt::format("Marks what is brighter than white red, and values that are no numbers "
                  "magenta ({})",
                  shortcut_text(Action::ClipWarning)));
  ImGui::Checkbox("Mark clipped##clipped", &display.show_clipped);
}

}  // namespace guidelight

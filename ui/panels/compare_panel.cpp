#include <fmt/format.h>

#include <array>

#include "ui/format.h"
#include "ui/panels/panels.h"
#include "ui/plot.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace guidelight {
namespace {

constexpr ImU32 kPresentColor = palette::kAccent;
constexpr ImU32 kPinnedColor = IM_COL32(120, 190, 255, 255);

void draw_sources(Comparison& comparison, const Perform& perform) {
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const float width = (ImGui::GetContentRegionAvail().x - gap) / 2;
  if (ImGui::Button("Reference…", {width, 0})) perform(Action::LoadReference);
  tooltip(
      fmt::format("{}: an EXR, HDR or PNG of the same size", action_label(Action::LoadReference)));
  ImGui::SameLine();
  if (ImGui::Button("Pin this", {width, 0})) perform(Action::PinPicture);
  tooltip(
      fmt::format("{} ({})", action_label(Action::PinPicture), shortcut_text(Action::PinPicture)));
  const bool has_reference = comparison.reference().image != nullptr;
  const bool has_pinned = comparison.pinned().image != nullptr;
  if (!has_reference && !has_pinned) {
    wrapped_dim_text(
        "Load a reference to see the error, or pin the present picture as A and render another "
        "algorithm as B.");
    return;
  }
  row("Against", "What the render is compared with");
  const float room = room_in_field(ImGui::CalcItemWidth()) - ImGui::GetFrameHeight();
  const std::string& name = comparison.other().name;
  const bool open = ImGui::BeginCombo("##against", shortened(name, room).c_str());
  if (!open) {
    tooltip(name);
    return;
  }
  const auto choice = [&](const ComparedImage& image, Comparison::Against against) {
    if (!image.image) return;
    const bool chosen = comparison.against() == against;
    if (ImGui::Selectable(image.name.c_str(), chosen)) comparison.compare_against(against);
  };
  choice(comparison.reference(), Comparison::Against::Reference);
  choice(comparison.pinned(), Comparison::Against::Pinned);
  ImGui::EndCombo();
}

std::string size_text(int width, int height) { return fmt::format("{} × {}", width, height); }

std::string why_not_comparable(const Document& document, const Comparison& comparison) {
  if (comparison.fits()) return "";
  const Image& other = *comparison.other().image;
  const RenderSettings& settings = document.settings();
  return fmt::format(
      "{} has {} pixels, the render has {}: only pictures of the same size can be compared.",
      comparison.other().name, size_text(other.width(), other.height()),
      size_text(settings.width, settings.height));
}

void draw_modes(Comparison& comparison, const std::string& obstacle) {
  using Mode = Comparison::Mode;
  row("View", "Holding Shift over the picture shows the other one alone");
  const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
  const float width = (ImGui::GetContentRegionAvail().x - gap) / 2;
  const auto mode = [&](const char* label, Mode which, const char* help) {
    const bool on = comparison.mode == which;
    ImGui::BeginDisabled(!obstacle.empty());
    if (toggle_button(label, on, {width, 0})) comparison.mode = on ? Mode::Off : which;
    ImGui::EndDisabled();
    tooltip(obstacle.empty() ? help : obstacle);
  };
  mode("Wipe", Mode::Wipe, "The other picture to the left of a line that can be dragged");
  ImGui::SameLine(0, gap);
  mode("Error map", Mode::ErrorMap,
       "Squared relative error of each pixel, dark 0.0001 to bright 10, logarithmic");
}

void draw_metrics(const Comparison& comparison) {
  const auto& metrics = comparison.metrics();
  if (!metrics) {
    wrapped_dim_text("They are measured after the next pass.");
    return;
  }
  readout("relMSE", format_value(static_cast<float>(metrics->relative_mse.plain)),
          "Mean of (I - R)² / (R² + 0.01)");
  readout("RMS", format_percent(metrics->rms_relative_error.plain),
          "Root of the mean squared relative error of the luminance");
  readout("Bias", fmt::format("{:+.2f} %", 100 * metrics->relative_bias),
          "Of the mean luminance of the whole picture");
}

std::vector<Vec2> error_points(const ErrorCurve& curve, double ErrorCurve::Point::*value) {
  std::vector<Vec2> points;
  for (const auto& point : curve.points) points.emplace_back(point.seconds, point.*value);
  return points;
}

void draw_curves(const Comparison& comparison) {
  const auto plot = [&](const char* title, const char* id, double ErrorCurve::Point::*value) {
    std::vector<PlotCurve> curves = {
        {comparison.curve().name, kPresentColor, error_points(comparison.curve(), value)}};
    if (!comparison.pinned_curve().points.empty()) {
      curves.push_back({"A: " + comparison.pinned_curve().name, kPinnedColor,
                        error_points(comparison.pinned_curve(), value)});
      curves[0].name = "B: " + curves[0].name;
    }
    dim_text(title);
    draw_plot(id, curves, {"s", "", true, true});
  };
  plot("relMSE over seconds, both logarithmic", "relmse", &ErrorCurve::Point::relative_mse);
  plot("RMS relative error over seconds", "rms", &ErrorCurve::Point::rms);
}

/// Both renders at the latest time that both have reached.
void draw_equal_time(const Comparison& comparison) {
  const ErrorCurve& a = comparison.pinned_curve();
  const ErrorCurve& b = comparison.curve();
  if (a.points.empty() || b.points.empty()) return;
  const double seconds = std::min(a.points.back().seconds, b.points.back().seconds);
  const auto at_a = a.at(seconds);
  const auto at_b = b.at(seconds);
  if (!at_a || !at_b) return;
  dim_text("At equal time, " + format_duration(seconds));
  if (!ImGui::BeginTable("equal time", 3)) return;
  ImGui::TableSetupColumn("");
  ImGui::TableSetupColumn("relMSE");
  ImGui::TableSetupColumn("RMS");
  ImGui::TableHeadersRow();
  const auto line = [](const char* name, const ErrorCurve::Point& point) {
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(name);
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(fmt::format("{:.3g}", point.relative_mse).c_str());
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(format_percent(point.rms).c_str());
  };
  line("A", *at_a);
  line("B", *at_b);
  ImGui::EndTable();
}

}  // namespace

void draw_compare_panel(const Document& document, Comparison& comparison, const Perform& perform) {
  if (!section("Compare")) return;
  if (!document.has_scene()) {
    wrapped_dim_text("Open a scene first.");
    return;
  }
  draw_sources(comparison, perform);
  if (!comparison.other().image) return;
  const std::string obstacle = why_not_comparable(document, comparison);
  draw_modes(comparison, obstacle);
  if (!obstacle.empty()) {
    wrapped_dim_text(obstacle);
    return;
  }
  draw_metrics(comparison);
  if (!comparison.reference().image || !section("Error over time")) return;
  draw_curves(comparison);
  draw_equal_time(comparison);
}

}  // namespace guidelight

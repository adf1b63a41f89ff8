#include <fmt/format.h>

#include "ui/format.h"
#include "ui/panels/panels.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace guidelight {
namespace {

struct StateText {
  const char* text;
  ImU32 color;
};

StateText state_text(const Document& document) {
  switch (document.status().state) {
    case SessionState::Rendering:
      return {document.status().coarse ? "Preview" : "Rendering", palette::kAccent};
    case SessionState::Paused:
      return {"Paused", palette::kDim};
    case SessionState::Finished:
      return {"Finished", palette::kNote};
    case SessionState::Failed:
      return {"Failed", palette::kError};
    case SessionState::Idle:
      break;
  }
  return {document.has_scene() ? "Starting" : "Ready", palette::kDim};
}

void draw_item(const std::string& text) {
  ImGui::SameLine(0, scaled(18));
  dim_text(text);
}

void draw_dot(ImU32 color) {
  const float line = ImGui::GetTextLineHeight();
  const Vec2 corner = from_imgui(ImGui::GetCursorScreenPos());
  ImGui::GetWindowDrawList()->AddCircleFilled(to_imgui(corner + Vec2(scaled(5), line / 2)),
                                              scaled(4), color);
  ImGui::Dummy({scaled(12), line});
  ImGui::SameLine(0, scaled(4));
}

void draw_render_state(const Document& document) {
  const StateText state = state_text(document);
  draw_dot(state.color);
  ImGui::TextUnformatted(state.text);
  const Snapshot& status = document.status();
  if (status.passes == 0) return;
  draw_item(fmt::format("{} pass{}", status.passes, status.passes == 1 ? "" : "es"));
  draw_item(format_duration(status.seconds));
  if (status.seconds > 0) {
    const double rate = static_cast<double>(status.samples) / status.seconds;
    draw_item(format_count(rate) + " samples/s");
  }
  if (status.passes > 1) draw_item("error " + format_percent(status.relative_error));
}

std::string progress_text(const Snapshot& status) {
  if (status.state == SessionState::Finished) return "100 %";
  const double left = status.seconds * (1 - status.progress) / std::max(status.progress, 1e-6f);
  return fmt::format("{:.0f} %, {} left", 100 * status.progress, format_duration(left));
}

}  // namespace

void draw_status_bar(const Document& document, float zoom, const std::string& loading) {
  if (!loading.empty()) {
    draw_dot(palette::kAccent);
    ImGui::TextUnformatted(("Reading " + shortened(loading, scaled(420))).c_str());
  } else {
    draw_render_state(document);
  }
  if (!document.has_scene()) return;

  std::string right = fmt::format("{:.0f} %", 100 * zoom);
  if (const auto pixel = document.view().hovered_pixel) {
    right = fmt::format("{}, {}     ", pixel->x, pixel->y) + right;
  }
  const float right_width = ImGui::CalcTextSize(right.c_str()).x;
  const float end = ImGui::GetWindowContentRegionMax().x;
  if (document.status().progress > 0) {
    const float width = scaled(230);
    ImGui::SameLine(end - right_width - scaled(18) - width);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {0, scaled(1)});
    ImGui::PushStyleColor(ImGuiCol_PlotHistogram, palette::kAccentSoft);
    ImGui::ProgressBar(document.status().progress, {width, ImGui::GetTextLineHeight() + scaled(2)},
                       progress_text(document.status()).c_str());
    ImGui::PopStyleColor();
    ImGui::PopStyleVar();
  }
  ImGui::SameLine(end - right_width);
  dim_text(right);
}

}  // namespace guidelight

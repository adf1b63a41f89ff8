#include <fmt/format.h>

#include <utility>

#include "ui/format.h"
#include "ui/panels/panels.h"
#include "ui/widgets.h"

namespace guidelight {
namespace {

std::string name_of_region(const PixelRegion& region) {
  const int width = region.x1 - region.x0;
  const int height = region.y1 - region.y0;
  if (width == 1 && height == 1) return fmt::format("pixel {}, {}", region.x0, region.y0);
  return fmt::format("{} × {} pixels at {}, {}", width, height, region.x0, region.y0);
}

void draw_choice_of_region(Document& document, bool tool_held, const Perform& perform) {
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const float width = (ImGui::GetContentRegionAvail().x - gap) / 2;
  if (toggle_button("Rectangle", tool_held, {width, 0})) perform(Action::HarvestTool);
  tooltip(fmt::format("{} ({})", action_label(Action::HarvestTool),
                      shortcut_text(Action::HarvestTool)));
  ImGui::SameLine();
  ImGui::BeginDisabled(!document.harvest().region);
  if (ImGui::Button("Release", {width, 0})) document.view().forget_picked();
  ImGui::EndDisabled();
  tooltip("Forgets what was picked");
}

void draw_path_row(Harvest& harvest, size_t i) {
  const HarvestedPath& path = harvest.paths[i];
  ImGui::PushID(static_cast<int>(i));
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  const std::string share = format_percent(path.share);
  const float room = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(share.c_str()).x;
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.0f, room));
  dim_text(share);
  ImGui::TableNextColumn();
  const std::string shown = shortened(path.guide.name, ImGui::GetContentRegionAvail().x);
  if (ImGui::Selectable(shown.c_str(), harvest.selected == i,
                        ImGuiSelectableFlags_SpanAllColumns)) {
    harvest.selected = harvest.selected == i ? std::nullopt : std::optional(i);
  }
  tooltip(fmt::format("{} of the light that was found comes by way of {}", share, path.guide.name));
  ImGui::PopID();
}

void draw_paths(Harvest& harvest, const Perform& perform) {
  if (ImGui::BeginTable("paths", 2, ImGuiTableFlags_SizingFixedFit)) {
    ImGui::TableSetupColumn("share", 0, ImGui::CalcTextSize("0.00 %").x);
    ImGui::TableSetupColumn("way", ImGuiTableColumnFlags_WidthStretch);
    for (size_t i = 0; i < harvest.paths.size(); ++i) draw_path_row(harvest, i);
    ImGui::EndTable();
  }
  if (ImGui::Button("Keep as a guide", {-FLT_MIN, 0})) perform(Action::KeepPath);
  if (std::exchange(harvest.is_news, false) && !ImGui::IsItemVisible()) ImGui::SetScrollHereY(1);
  tooltip(
      fmt::format("The selected one, else the strongest ({})", shortcut_text(Action::KeepPath)));
}

}  // namespace

void draw_harvest_panel(Document& document, bool tool_held, const Perform& perform) {
  if (!section("Light that arrives")) return;
  draw_choice_of_region(document, tool_held, perform);
  Harvest& harvest = document.harvest();
  if (!harvest.region) {
    wrapped_dim_text(
        "Click a pixel of the picture, or drag a rectangle, to see on which ways light reaches "
        "it.");
    return;
  }
  wrapped_dim_text("Light of " + name_of_region(*harvest.region) + ", by way of");
  tooltip("Counted from the upper left corner of the picture");
  if (harvest.searching) {
    dim_text("Searching …");
  } else if (harvest.paths.empty()) {
    wrapped_dim_text("None was found: no indirect or direct light arrives there.");
  } else {
    draw_paths(harvest, perform);
  }
}

}  // namespace guidelight

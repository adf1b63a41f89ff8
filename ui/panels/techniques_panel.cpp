#include "ui/format.h"
#include "ui/panels/panels.h"
#include "ui/widgets.h"

namespace guidelight {

void draw_techniques_panel(Document& document, const Perform& perform) {
  if (!document.has_scene() || !section("Techniques")) return;
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const float half = (ImGui::GetContentRegionAvail().x - gap) / 2;
  TechniqueView& view = document.technique_view();
  action_button("Record", Action::RecordTechniques, document.records_techniques(), half, document,
                perform);
  ImGui::SameLine();
  action_button("Show all", Action::ShowTechniques, view.shown, half, document, perform);
  if (!document.techniques()) return;
  row("Values", "What a technique brings");
  const float inner = ImGui::GetStyle().ItemInnerSpacing.x;
  const float width = (ImGui::GetContentRegionAvail().x - inner) / 2;
  if (toggle_button("Weighted", view.weighted, {width, 0})) view.weighted = true;
  tooltip("As the balance heuristic weighs them: together they are the picture");
  ImGui::SameLine(0, inner);
  if (toggle_button("Raw", !view.weighted, {width, 0})) view.weighted = false;
  tooltip("As each would count if it were the only one for its paths");
  readout("Memory", format_bytes(document.techniques()->bytes()),
          "Of what is recorded, for paths of up to " +
              std::to_string(document.techniques()->longest_path()) + " segments");
}

}  // namespace guidelight

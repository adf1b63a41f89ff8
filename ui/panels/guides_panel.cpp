#include <fmt/format.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "ui/format.h"
#include "ui/panels/panels.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace guidelight {
namespace {

constexpr float kDegree = kPi / 180;
constexpr const char* kGuided = "guided";  // the parameter of Markov chains

/// Changes a copy of one guide; steps of one kind are undone together while the mouse is held.
template <class Change>
void edit_guide(Document& document, size_t guide, const std::string& label, Change change,
                const std::string& kind = "") {
  std::vector<GuidePath> guides = *document.guides();
  change(guides[guide]);
  document.edit_guides(std::move(guides), label, kind);
}

void draw_guide_commands(const Document& document, bool tool_active, const Perform& perform) {
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const float width = (ImGui::GetContentRegionAvail().x - 2 * gap) / 3;
  const auto command = [&](const char* label, Action action, bool on) {
    action_button(label, action, on, width, document, perform);
  };
  command("New", Action::NewGuide, tool_active);
  ImGui::SameLine();
  command("Duplicate", Action::DuplicateGuide, false);
  ImGui::SameLine();
  command("Delete", Action::DeleteGuide, false);
}

void draw_hint_for_first_guide() {
  wrapped_dim_text(
      "A guide path shows the renderer a way for light that it would rarely find by itself. The "
      "result stays exact; only the noise changes.");
  ImGui::Dummy({0, scaled(2)});
  wrapped_dim_text(fmt::format("1.  Press {} and click a light.", shortcut_text(Action::NewGuide)));
  wrapped_dim_text("2.  Click the surfaces that its light should reach, one after another.");
  wrapped_dim_text(fmt::format("3.  Enter ends the path. {} shows the scene from elsewhere.",
                               shortcut_text(Action::CycleViews)));
}

// -- The list.

/// Of the guides that are followed.
double total_weight(const Document& document) {
  double total = 0;
  for (size_t i = 0; i < document.guides()->size(); ++i) {
    const GuidePath& guide = (*document.guides())[i];
    if (guide.enabled && document.guide_faults(i).empty()) total += guide.weight;
  }
  return total;
}

void draw_guide_row(Document& document, size_t i, double total) {
  const GuidePath guide = (*document.guides())[i];
  GuideView& view = document.guide_view();
  ImGui::PushID(static_cast<int>(i));
  ImGui::TableNextRow();

  ImGui::TableNextColumn();
  bool enabled = guide.enabled;
  if (ImGui::Checkbox("##on", &enabled)) {
    edit_guide(document, i, enabled ? "switching on a guide" : "switching off a guide",
               [&](GuidePath& g) { g.enabled = enabled; });
  }
  tooltip(enabled ? "Is followed" : "Is not followed");

  ImGui::TableNextColumn();
  Color color = guide.color;
  if (ImGui::ColorEdit3("##color", &color.x,
                        ImGuiColorEditFlags_NoInputs | ImGuiColorEditFlags_NoLabel |
                            ImGuiColorEditFlags_NoTooltip)) {
    edit_guide(
        document, i, "colour of a guide", [&](GuidePath& g) { g.color = color; }, "colour");
  }
  tooltip("Colour in the views");

  ImGui::TableNextColumn();
  const auto& faults = document.guide_faults(i);
  ImGui::AlignTextToFramePadding();
  if (!faults.empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, palette::kError);
    ImGui::TextUnformatted("!");
    ImGui::PopStyleColor();
    ImGui::SameLine(0, scaled(4));
  }
  const std::string name = shortened(guide.name, ImGui::GetContentRegionAvail().x - scaled(4));
  if (ImGui::Selectable((name + "##name").c_str(), view.selected == i)) {
    view.selected = view.selected == i ? std::nullopt : std::optional(i);
  }
  if (!faults.empty()) tooltip("Cannot be followed: " + faults.front().message);

  ImGui::TableNextColumn();
  ImGui::AlignTextToFramePadding();
  const bool followed = guide.enabled && faults.empty() && total > 0;
  dim_text(followed ? fmt::format("{:.0f} %", 100 * guide.weight / total) : "–");
  tooltip("Share among the guides that are followed");

  ImGui::TableNextColumn();
  if (toggle_button("S", view.solo == i)) {
    document.set_solo(view.solo == i ? std::nullopt : std::optional(i));
  }
  tooltip("Solo: only this guide is followed, until you press it again");
  ImGui::PopID();
}

void draw_list(Document& document) {
  ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, {scaled(4), ImGui::GetStyle().CellPadding.y});
  const bool open = ImGui::BeginTable("guides", 5, ImGuiTableFlags_SizingFixedFit);
  ImGui::PopStyleVar();
  if (!open) return;
  ImGui::TableSetupColumn("on");
  ImGui::TableSetupColumn("color");
  ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthStretch);
  ImGui::TableSetupColumn("share");
  ImGui::TableSetupColumn("solo");
  const double total = total_weight(document);
  for (size_t i = 0; i < document.guides()->size(); ++i) draw_guide_row(document, i, total);
  ImGui::EndTable();
}

// -- The selected guide.

void draw_cone_rows(Document& document, size_t selected, const GuidePath& guide) {
  for (size_t i = 0; i + 1 < guide.vertices.size(); ++i) {
    const GuideVertex& vertex = guide.vertices[i];
    const std::string label = fmt::format("Cone {}", i + 1);
    if (vertex.event != PathEvent::Scatter) {
      readout(label.c_str(), vertex.event == PathEvent::Reflect ? "mirror" : "refraction",
              "The path has no choice here");
      continue;
    }
    float degrees = vertex.cone / kDegree;
    row(label.c_str(), "Half-angle of the directions that leave vertex " + std::to_string(i + 1) +
                           " [degrees]. A wide cone finds more, a narrow one wastes less.");
    if (number(("##cone" + std::to_string(i)).c_str(), degrees, 0.05f, 90, "°")) {
      edit_guide(
          document, selected, "cone of a guide",
          [&](GuidePath& g) { g.vertices[i].cone = std::clamp(degrees, 0.05f, 90.0f) * kDegree; },
          label);
    }
  }
}

void draw_selected(Document& document, size_t selected) {
  const GuidePath guide = (*document.guides())[selected];
  for (const GuideFault& fault : document.guide_faults(selected)) {
    ImGui::PushStyleColor(ImGuiCol_Text, palette::kError);
    ImGui::TextWrapped("Vertex %d: %s.", fault.vertex + 1, fault.message.c_str());
    ImGui::PopStyleColor();
  }
  row("Name");
  std::string name = guide.name;
  if (ImGui::InputText("##name", &name)) {
    edit_guide(
        document, selected, "name of a guide", [&](GuidePath& g) { g.name = name; }, "name");
  }
  row("Weight", "Share among the guides; the shares need not add up to anything");
  float weight = guide.weight;
  if (number("##weight", weight, 0, 1000, "")) {
    edit_guide(
        document, selected, "weight of a guide", [&](GuidePath& g) { g.weight = weight; },
        "weight");
  }
  row("Disc",
      "Paths start within this radius around the first vertex on the light [scene units, which "
      "count as metres]");
  float radius = guide.disc_radius;
  if (number("##disc", radius, 1e-6f, 1e6f, "m", true)) {
    edit_guide(
        document, selected, "disc of a guide",
        [&](GuidePath& g) { g.disc_radius = std::max(radius, 1e-6f); }, "disc");
  }
  draw_cone_rows(document, selected, guide);
  const GuideCandidates& candidates = document.candidates();
  if (!candidates.candidates.empty()) {
    readout("Arrive", format_percent(candidates.valid_share()),
            fmt::format("Of {} paths drawn from the cones, those that meet the same kinds of "
                        "surfaces; the others are wasted",
                        candidates.candidates.size()));
  }
}

// -- What holds for all.

bool is_guide_parameter(const Parameter& parameter) { return parameter.key.starts_with("guide"); }

bool follows_guides(IntegratorSettings& settings) {
  return std::ranges::any_of(settings.parameters(), is_guide_parameter);
}

/// What Markov chains divide between guided paths (UP) and independent ones (BD).
bool edit_up_to_bd(float& guided, float& independent) {
  const float both = guided + independent;
  if (!(both > 0)) return false;
  row("UP : BD",
      "How often chains propose paths that follow a guide, and how often independent ones. "
      "Changing it restarts the render.");
  float percent = 100 * guided / both;
  const std::string shown = fmt::format("{:.0f} : {:.0f}", percent, 100 - percent);
  if (!ImGui::SliderFloat("##up to bd", &percent, 0, 100, shown.c_str(),
                          ImGuiSliderFlags_NoInput)) {
    return false;
  }
  guided = both * percent / 100;
  independent = both - guided;
  return true;
}

float* number_named(const std::vector<Parameter>& parameters, const std::string& key) {
  const auto found = std::ranges::find(parameters, key, &Parameter::key);
  const auto number = found == parameters.end() ? nullptr : std::get_if<float*>(&found->value);
  return number ? *number : nullptr;
}

/// The share of guided paths, or which algorithms there are to choose from.
void draw_guided_share(Document& document) {
  if (!document.settings().parameters) return;
  std::shared_ptr<IntegratorSettings> edited = document.settings().parameters->clone();
  if (!follows_guides(*edited)) {
    std::string names;
    for (const IntegratorInfo& info : integrators()) {
      if (!follows_guides(*info.make_settings({}))) continue;
      names += (names.empty() ? "" : ", ") + info.label;
    }
    ImGui::PushStyleColor(ImGuiCol_Text, palette::kWarning);
    ImGui::TextWrapped("%s follows no guides. These do: %s.",
                       find_integrator(document.settings().integrator).label.c_str(),
                       names.c_str());
    ImGui::PopStyleColor();
    return;
  }
  bool changed = false;
  const std::vector<Parameter> parameters = edited->parameters();
  float* guided = number_named(parameters, kGuided);
  float* independent = number_named(parameters, "bidirectional");
  if (guided && independent) changed |= edit_up_to_bd(*guided, *independent);
  for (const Parameter& parameter : parameters) {
    const bool is_drawn = independent && parameter.key == kGuided;
    if (is_guide_parameter(parameter) && !is_drawn) changed |= draw_parameter(parameter);
  }
  if (!changed) return;
  RenderSettings settings = document.settings();
  settings.parameters = std::move(edited);
  document.set_settings(settings);
}

void draw_options(Document& document, const std::string& file) {
  GuideView& view = document.guide_view();
  row("Show", fmt::format("In both views ({})", shortcut_text(Action::ShowGuides)));
  ImGui::Checkbox("Guides##shown", &view.shown);
  row("", "");
  ImGui::Checkbox("Sample paths##candidates", &view.candidates_shown);
  tooltip("Of the selected guide; red ones are wasted");
  row("Glass", "Which way a path takes where a smooth surface does both");
  int choice = static_cast<int>(view.choice);
  if (ImGui::Combo("##choice", &choice, "Refract\0Reflect\0")) {
    view.choice = static_cast<SpecularChoice>(choice);
  }
  row("Swing", "Segments of a path that is swung from a light");
  number("##swing", view.swing_bounces, 1, 16, view.swing_bounces == 1 ? "segment" : "segments");
  if (!document.guides()->empty()) {
    const size_t slash = file.find_last_of('/');
    readout("Saved in", slash == std::string::npos ? file : file.substr(slash + 1),
            "After every change");
    tooltip(file);
  }
}

}  // namespace

void draw_guides_panel(Document& document, const ToolsHeld& tools, const std::string& file,
                       const Perform& perform) {
  if (!document.has_scene()) {
    wrapped_dim_text("Open a scene first.");
    return;
  }
  if (section("Guide paths")) {
    draw_guide_commands(document, tools.guide, perform);
    if (document.guides()->empty()) {
      draw_hint_for_first_guide();
    } else {
      draw_list(document);
      draw_guided_share(document);
    }
  }
  const auto selected = document.guide_view().selected;
  if (selected && section("Selected guide")) draw_selected(document, *selected);
  if (!document.guides()->empty()) draw_guide_statistics(document);
  draw_harvest_panel(document, tools.harvest, perform);
  if (section("Placing and showing")) draw_options(document, file);
}

}  // namespace guidelight

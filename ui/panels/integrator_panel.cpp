#include <algorithm>

#include "ui/panels/panels.h"
#include "ui/widgets.h"

namespace guidelight {
namespace {

constexpr const char* kRestarts = "Changing it restarts the render.";

/// As wide as the panel, because names are long.
void draw_integrator_choice(Document& document) {
  const IntegratorInfo& current = find_integrator(document.settings().integrator);
  ImGui::SetNextItemWidth(-FLT_MIN);
  const float width = room_in_field(ImGui::CalcItemWidth()) - ImGui::GetFrameHeight();
  const bool open = ImGui::BeginCombo("##integrator", shortened(current.label, width).c_str(),
                                      ImGuiComboFlags_HeightLargest);
  if (!open) tooltip(std::string("How light is simulated. ") + kRestarts);
  if (open) {
    for (const IntegratorInfo& info : integrators()) {
      const bool chosen = info.name == current.name;
      if (ImGui::Selectable(info.label.c_str(), chosen) && !chosen) {
        document.set_integrator(info.name);
      }
      tooltip(info.summary);
    }
    ImGui::EndCombo();
  }
  wrapped_dim_text(current.summary);
}

/// The widget of one parameter; returns whether its value was changed.
struct ParameterWidget {
  const Parameter& parameter;
  const char* id;

  bool operator()(bool* value) const { return ImGui::Checkbox(id, value); }

  /// A minimum of -1 stands for no limit.
  bool operator()(int* value) const {
    const bool unlimited = parameter.minimum == -1 && *value == -1;
    return number(id, *value, static_cast<int>(parameter.minimum),
                  static_cast<int>(parameter.maximum), unlimited ? "(no limit)" : parameter.unit);
  }

  bool operator()(float* value) const {
    return number(id, *value, static_cast<float>(parameter.minimum),
                  static_cast<float>(parameter.maximum), parameter.unit, parameter.logarithmic);
  }

  bool operator()(const Parameter::Choice& choice) const {
    bool changed = false;
    if (ImGui::BeginCombo(id, choice_text(choice.names[*choice.value]).c_str())) {
      for (int i = 0; i < static_cast<int>(choice.names.size()); ++i) {
        const bool chosen = i == *choice.value;
        if (ImGui::Selectable(choice_text(choice.names[i]).c_str(), chosen) && !chosen) {
          *choice.value = i;
          changed = true;
        }
      }
      ImGui::EndCombo();
    }
    return changed;
  }
};

}  // namespace

std::string choice_text(std::string name) {
  std::ranges::replace(name, '_', ' ');
  return name;
}

bool draw_parameter(const Parameter& parameter, float column) {
  const bool unused = !parameter.unused.empty();
  const std::string reason = "It has no effect now: " + parameter.unused;
  row(parameter.label.c_str(), parameter.help + " " + (unused ? reason : kRestarts), column);
  const std::string id = "##" + parameter.key;
  ImGui::BeginDisabled(unused);
  const bool changed = std::visit(ParameterWidget{parameter, id.c_str()}, parameter.value);
  ImGui::EndDisabled();
  if (unused) tooltip(reason);
  return changed;
}

float settings_column(const std::vector<Parameter>& parameters) {
  constexpr float kLeastShare = 0.46f;  // at the usual width all labels need no more
  std::vector<std::string> labels;
  for (const Parameter& parameter : parameters) labels.push_back(parameter.label);
  return label_column(labels, kLeastShare);
}

void draw_integrator_panel(Document& document, float column) {
  if (!document.has_scene() || !section("Integrator")) return;
  const std::shared_ptr<IntegratorSettings> edited = document.settings().parameters->clone();
  const std::vector<Parameter> parameters = edited->parameters();
  draw_integrator_choice(document);
  bool changed = false;
  for (const Parameter& parameter : parameters) changed |= draw_parameter(parameter, column);
  if (!changed) return;
  RenderSettings settings = document.settings();
  settings.parameters = edited;
  document.set_settings(settings);
}

}  // namespace guidelight

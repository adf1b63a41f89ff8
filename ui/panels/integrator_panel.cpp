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
  const float width = ImGui::CalcItemWidth() - ImGui::GetFrameHeight() - scaled(12);
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

/// A key as words: "own_path" is shown as "own path".
std::string words(std::string key) {
  std::ranges::replace(key, '_', ' ');
  return key;
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
    if (ImGui::BeginCombo(id, words(choice.names[*choice.value]).c_str())) {
      for (int i = 0; i < static_cast<int>(choice.names.size()); ++i) {
        const bool chosen = i == *choice.value;
        if (ImGui::Selectable(words(choice.names[i]).c_str(), chosen) && !chosen) {
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

bool draw_parameter(const Parameter& parameter, float column) {
  row(parameter.label.c_str(), parameter.help + " " + kRestarts, column);
  const std::string id = "##" + parameter.key;
  return std::visit(ParameterWidget{parameter, id.c_str()}, parameter.value);
}

void draw_integrator_panel(Document& document) {
  if (!document.has_scene() || !section("Integrator")) return;
  const std::shared_ptr<IntegratorSettings> edited = document.settings().parameters->clone();
  const std::vector<Parameter> parameters = edited->parameters();
  std::vector<std::string> labels;
  for (const Parameter& parameter : parameters) labels.push_back(parameter.label);
  const float column = label_column(labels);
  draw_integrator_choice(document);
  bool changed = false;
  for (const Parameter& parameter : parameters) changed |= draw_parameter(parameter, column);
  if (!changed) return;
  RenderSettings settings = document.settings();
  settings.parameters = edited;
  document.set_settings(settings);
}

}  // namespace guidelight

#include <fmt/format.h>

#include <cstring>
#include <filesystem>

#include "ui/panels/panels.h"
#include "ui/widgets.h"

namespace guidelight {
namespace {

void draw_recent_menu(const RecentFiles& recent,
                      const std::function<void(const std::string&)>& open_scene) {
  if (!ImGui::BeginMenu("Open recent", !recent.paths().empty())) return;
  for (const std::string& path : recent.paths()) {
    if (ImGui::MenuItem(shortened(path, scaled(420)).c_str())) open_scene(path);
  }
  ImGui::EndMenu();
}

std::string why_no_techniques(Action action, const Document& document) {
  if (!document.has_scene()) return "No scene is open";
  const IntegratorInfo& info = find_integrator(document.settings().integrator);
  if (!info.combines_techniques) {
    return info.label +
           " is one technique alone: choose a bidirectional algorithm, or vertex "
           "connection and merging";
  }
  if (action == Action::ShowTechniques && !document.techniques()) {
    return fmt::format("Techniques are not recorded: press Record ({})",
                       shortcut_text(Action::RecordTechniques));
  }
  return "";
}

}  // namespace

/// One menu per group of the key table, in its order.
std::string why_disabled(Action action, const Document& document) {
  const bool selected = document.guide_view().selected.has_value();
  switch (action) {
    case Action::Undo:
      return document.undo_label().empty() ? "Nothing has been changed yet" : "";
    case Action::Redo:
      return document.redo_label().empty() ? "Nothing has been undone" : "";
    case Action::DuplicateGuide:
    case Action::DeleteGuide:
      return selected ? "" : "No guide is selected: choose one in the list or by a vertex";
    case Action::KeepPath:
      return document.harvest().paths.empty() ? "No light path is shown: pick a pixel or a "
                                                "rectangle while the Guides tab is open"
                                              : "";
    case Action::RecordTechniques:
    case Action::ShowTechniques:
      return why_no_techniques(action, document);
    case Action::OpenScene:
    case Action::ResumeCheckpoint:
    case Action::Quit:
    case Action::WindowCapture:
    case Action::KeySheet:
    case Action::HideUi:
    case Action::LargerUi:
    case Action::SmallerUi:
    case Action::CycleViews:
      return "";
    default:
      return document.has_scene() ? "" : "No scene is open";
  }
}

void action_button(const char* label, Action action, bool on, float width, const Document& document,
                   const Perform& perform) {
  const std::string reason = why_disabled(action, document);
  ImGui::BeginDisabled(!reason.empty());
  if (toggle_button(label, on, {width, 0})) perform(action);
  ImGui::EndDisabled();
  tooltip(reason.empty() ? fmt::format("{} ({})", action_label(action), shortcut_text(action))
                         : reason);
}

std::string menu_label(Action action, const Document& document) {
  const std::string label = action_label(action);
  const std::string step = action == Action::Undo   ? document.undo_label()
                           : action == Action::Redo ? document.redo_label()
                                                    : "";
  return step.empty() ? label : label + " " + step;
}

void draw_menu_bar(const Document& document, const RecentFiles& recent, const Perform& perform,
                   const std::function<void(const std::string&)>& open_scene, ViewLayout& views) {
  if (!ImGui::BeginMainMenuBar()) return;
  const auto bindings = key_bindings();
  for (size_t i = 0; i < bindings.size();) {
    const char* group = bindings[i].group;
    const bool open = ImGui::BeginMenu(group);
    for (; i < bindings.size() && std::strcmp(bindings[i].group, group) == 0; ++i) {
      if (!open) continue;
      const KeyBinding& binding = bindings[i];
      const std::string keys = key_text(binding.key, binding.modifiers);
      const std::string label = menu_label(binding.action, document);
      const std::string reason = why_disabled(binding.action, document);
      if (ImGui::MenuItem(label.c_str(), keys.c_str(), false, reason.empty())) {
        perform(binding.action);
      }
      if (!reason.empty()) tooltip(reason);
      if (binding.action == Action::OpenScene) draw_recent_menu(recent, open_scene);
    }
    if (open) ImGui::EndMenu();
  }
  views.draw_buttons();
  ImGui::EndMainMenuBar();
}

}  // namespace guidelight

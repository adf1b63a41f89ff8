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

}  // namespace

/// One menu per group of the key table, in its order.
void draw_menu_bar(const RecentFiles& recent, const Perform& perform,
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
      if (ImGui::MenuItem(binding.label, keys.c_str())) perform(binding.action);
      if (binding.action == Action::OpenScene) draw_recent_menu(recent, open_scene);
    }
    if (open) ImGui::EndMenu();
  }
  views.draw_buttons();
  ImGui::EndMainMenuBar();
}

}  // namespace guidelight

#include "ui/panels/tabs.h"

#include <imgui.h>

namespace guidelight {

bool Tabs::begin() { return ImGui::BeginTabBar("tabs", ImGuiTabBarFlags_FittingPolicyScroll); }

bool Tabs::tab(Name name) {
  static constexpr const char* kLabels[] = {"Image", "Guides", "Photons", "Compare"};
  const bool chosen = requested_ == name;
  if (chosen) requested_.reset();
  const int flags = chosen ? ImGuiTabItemFlags_SetSelected : ImGuiTabItemFlags_None;
  const bool open = ImGui::BeginTabItem(kLabels[name], nullptr, flags);
  if (open) shown_ = name;
  return open;
}

}  // namespace guidelight

#include "ui/panels/tabs.h"

#include <imgui.h>

#include "ui/widgets.h"

namespace guidelight {

bool Tabs::begin() {
  // All labels fit into a column of the usual width.
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {scaled(6), ImGui::GetStyle().FramePadding.y});
  const bool open = ImGui::BeginTabBar("tabs", ImGuiTabBarFlags_FittingPolicyScroll);
  ImGui::PopStyleVar();
  return open;
}

bool Tabs::tab(Name name) {
  static constexpr const char* kLabels[] = {"Image", "Guides", "Photons", "Compare"};
  const bool chosen = requested_ == name;
  if (chosen) requested_.reset();
  const int flags = chosen ? ImGuiTabItemFlags_SetSelected : ImGuiTabItemFlags_None;
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {scaled(6), ImGui::GetStyle().FramePadding.y});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemInnerSpacing, {scaled(2), 0});
  const bool open = ImGui::BeginTabItem(kLabels[name], nullptr, flags);
  ImGui::PopStyleVar(2);
  if (open) shown_ = name;
  return open;
}

}  // namespace guidelight

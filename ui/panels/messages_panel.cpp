#include "ui/panels/panels.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace guidelight {
namespace {

ImU32 color_of(Messages::Kind kind) {
  switch (kind) {
    case Messages::Kind::Note:
      return palette::kNote;
    case Messages::Kind::Warning:
      return palette::kWarning;
    case Messages::Kind::Error:
      return palette::kError;
  }
  return palette::kNote;
}

/// Returns the height used, and whether the message was clicked away.
std::pair<float, bool> draw_message(const Messages::Message& message, ImVec2 lower_left,
                                    float width) {
  const std::string name = "message " + std::to_string(message.id);
  ImGui::SetNextWindowPos(lower_left, ImGuiCond_Always, {0, 1});
  ImGui::PushStyleColor(ImGuiCol_WindowBg, palette::kRaised);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {scaled(16), scaled(10)});
  ImGui::Begin(name.c_str(), nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoFocusOnAppearing);
  ImGui::PushTextWrapPos(width - scaled(48));
  ImGui::TextUnformatted(message.text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::SameLine(0, scaled(14));
  const bool hovered = ImGui::IsWindowHovered();
  ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(hovered ? palette::kText : palette::kDim), "×");

  const Vec2 corner = from_imgui(ImGui::GetWindowPos());
  const float height = ImGui::GetWindowHeight();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRectFullScreen();  // the stripe lies in the padding
  list.AddRectFilled(to_imgui(corner), to_imgui(corner + Vec2(scaled(5), height)),
                     color_of(message.kind), scaled(5), ImDrawFlags_RoundCornersLeft);
  list.PopClipRect();
  const bool clicked = hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Left);
  ImGui::End();
  ImGui::PopStyleVar();
  ImGui::PopStyleColor();
  return {height, clicked};
}

}  // namespace

void draw_messages(Messages& messages, ImVec2 corner, float width) {
  std::optional<uint64_t> dismissed;
  const auto& shown = messages.shown();
  for (auto message = shown.rbegin(); message != shown.rend(); ++message) {
    const auto [height, clicked] = draw_message(*message, corner, width);
    if (clicked) dismissed = message->id;
    corner.y -= height + scaled(8);
  }
  if (dismissed) messages.dismiss(*dismissed);
}

}  // namespace guidelight

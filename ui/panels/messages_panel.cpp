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

/// What became of a message: it was clicked away, or its offer was taken.
enum class Answer { None, Dismissed, Taken };

/// Returns the height used.
std::pair<float, Answer> draw_message(const Messages::Message& message, ImVec2 lower_left,
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
  bool taken = false;
  if (!message.offer.label.empty()) taken = ImGui::Button(message.offer.label.c_str());
  const bool on_offer = !message.offer.label.empty() && ImGui::IsItemHovered();
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
  const bool clicked = hovered && !on_offer && ImGui::IsMouseClicked(ImGuiMouseButton_Left);
  ImGui::End();
  ImGui::PopStyleVar();
  ImGui::PopStyleColor();
  return {height, taken ? Answer::Taken : clicked ? Answer::Dismissed : Answer::None};
}

}  // namespace

void draw_messages(Messages& messages, ImVec2 corner, float width) {
  std::optional<uint64_t> dismissed;
  std::function<void()> act;
  const auto& shown = messages.shown();
  for (auto message = shown.rbegin(); message != shown.rend(); ++message) {
    const auto [height, answer] = draw_message(*message, corner, width);
    if (answer != Answer::None) dismissed = message->id;
    if (answer == Answer::Taken) act = message->offer.act;
    corner.y -= height + scaled(8);
  }
  if (dismissed) messages.dismiss(*dismissed);
  if (act) act();
}

}  // namespace guidelight

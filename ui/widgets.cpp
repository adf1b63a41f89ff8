#include "ui/widgets.h"

#include <algorithm>

#include "ui/theme.h"

namespace guidelight {
namespace {

constexpr float kBodySize = 16;
constexpr float kLabelShare = 0.40f;  // of a panel's width

float text_width(const std::string& text) { return ImGui::CalcTextSize(text.c_str()).x; }

/// Byte positions where characters of UTF-8 text begin, and its end.
std::vector<size_t> character_starts(const std::string& text) {
  std::vector<size_t> starts;
  for (size_t i = 0; i < text.size(); ++i) {
    if ((static_cast<unsigned char>(text[i]) & 0xc0) != 0x80) starts.push_back(i);
  }
  starts.push_back(text.size());
  return starts;
}

void row_label(const char* label, const std::string& help) {
  const float left = ImGui::GetCursorPosX();
  const float column = left + kLabelShare * ImGui::GetContentRegionAvail().x;
  ImGui::AlignTextToFramePadding();
  dim_text(label);
  if (!help.empty()) tooltip(help);
  ImGui::SameLine(column);
}

}  // namespace

float scaled(float length) { return std::round(length * ImGui::GetFontSize() / kBodySize); }

bool section(const char* title) {
  ImGui::Dummy({0, scaled(2)});
  ImGui::PushFont(heading_font());
  ImGui::PushStyleColor(ImGuiCol_Header, IM_COL32(0, 0, 0, 0));
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {scaled(2), scaled(4)});
  const bool open = ImGui::CollapsingHeader(title, ImGuiTreeNodeFlags_DefaultOpen);
  ImGui::PopStyleVar();
  ImGui::PopStyleColor();
  ImGui::PopFont();
  return open;
}

void row(const char* label, const std::string& help) {
  row_label(label, help);
  ImGui::SetNextItemWidth(-FLT_MIN);
}

void row_with_unit(const char* label, const std::string& unit, const std::string& help) {
  row_label(label, help);
  const float unit_width = unit.empty() ? 0 : text_width(unit) + scaled(7);
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - unit_width);
}

void unit_text(const std::string& unit) {
  if (unit.empty()) return;
  ImGui::SameLine(0, scaled(7));
  dim_text(unit);
}

void readout(const char* label, const std::string& value, const std::string& help) {
  row_label(label, help);
  const std::string shown = shortened(value, ImGui::GetContentRegionAvail().x);
  ImGui::TextUnformatted(shown.c_str());
  if (shown != value) tooltip(value);
}

void dim_text(const std::string& text) {
  ImGui::PushStyleColor(ImGuiCol_Text, palette::kDim);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopStyleColor();
}

void wrapped_dim_text(const std::string& text) {
  ImGui::PushTextWrapPos(0);
  dim_text(text);
  ImGui::PopTextWrapPos();
}

void tooltip(const std::string& text) {
  if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {scaled(10), scaled(7)});
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(scaled(360));
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
  ImGui::PopStyleVar();
}

bool toggle_button(const char* label, bool on, ImVec2 size) {
  if (on) {
    ImGui::PushStyleColor(ImGuiCol_Button, palette::kAccent);
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered, palette::kAccent);
    ImGui::PushStyleColor(ImGuiCol_Text, palette::kOnAccent);
  }
  const bool pressed = ImGui::Button(label, size);
  if (on) ImGui::PopStyleColor(3);
  return pressed;
}

std::string shortened(const std::string& text, float width) {
  if (text_width(text) <= width) return text;
  const std::vector<size_t> starts = character_starts(text);
  std::string best = "…";
  for (size_t kept = 2; kept < starts.size(); ++kept) {
    const size_t head = kept / 2;
    const size_t tail = kept - head;
    const std::string candidate =
        text.substr(0, starts[head]) + "…" + text.substr(starts[starts.size() - 1 - tail]);
    if (text_width(candidate) > width) break;
    best = candidate;
  }
  return best;
}

}  // namespace guidelight

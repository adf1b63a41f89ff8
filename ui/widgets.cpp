#include "ui/widgets.h"

#include <fmt/format.h>
#include <imgui_internal.h>

#include <algorithm>

#include "ui/theme.h"

namespace guidelight {
namespace {

constexpr float kLabelShare = 0.35f;  // of a panel's width
constexpr float kLargestLabelShare = 0.5f;

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

float needed_width(const std::string& label) {
  return text_width(label) + ImGui::GetStyle().ItemInnerSpacing.x;
}

float usual_column() { return kLabelShare * ImGui::GetContentRegionAvail().x; }

void row_label(const char* label, const std::string& help, float column = 0) {
  const float left = ImGui::GetCursorPosX();
  if (column <= 0) column = std::max(usual_column(), needed_width(label));
  dim_text(shortened(label, column - ImGui::GetStyle().ItemInnerSpacing.x));
  if (!help.empty()) tooltip(help);
  ImGui::SameLine(left + column);
}

std::string with_unit(const std::string& text, const std::string& unit) {
  return unit.empty() ? text : text + " " + unit;
}

/// The unit as part of a printf format; left out if there is no room for it.
std::string field_format(const char* number_format, const std::string& whole,
                         const std::string& unit) {
  if (text_width(whole) > room_in_field(ImGui::CalcItemWidth())) return number_format;
  std::string escaped;
  for (const char c : unit) escaped += c == '%' ? std::string("%%") : std::string(1, c);
  return with_unit(number_format, escaped);
}

/// "1 segment", "2 segments".
std::string unit_of(int count, const std::string& unit) {
  const bool one_of_many = count == 1 && unit.ends_with('s');
  return one_of_many ? unit.substr(0, unit.size() - 1) : unit;
}

/// Fields that are disabled have their reason instead.
void explain_entering() {
  const bool disabled = ImGui::GetCurrentContext()->CurrentItemFlags & ImGuiItemFlags_Disabled;
  if (!disabled) tooltip("Drag, or double-click to type.");
}

}  // namespace

float scaled(float length) { return std::round(length * ImGui::GetFontSize() / kBodySize); }

ImU32 faded(ImU32 color, float factor) {
  const auto alpha = static_cast<float>(color >> IM_COL32_A_SHIFT & 255);
  return (color & ~IM_COL32_A_MASK) | static_cast<ImU32>(alpha * factor) << IM_COL32_A_SHIFT;
}

ImU32 to_imgui_color(Color c, float alpha) {
  return ImGui::ColorConvertFloat4ToU32({c.r, c.g, c.b, alpha});
}

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

float label_column(const std::vector<std::string>& labels, float least_share) {
  float widest = least_share * ImGui::GetContentRegionAvail().x;
  for (const std::string& label : labels) widest = std::max(widest, needed_width(label));
  return std::round(std::min(widest, kLargestLabelShare * ImGui::GetContentRegionAvail().x));
}

void row(const char* label, const std::string& help, float column) {
  ImGui::AlignTextToFramePadding();
  row_label(label, help, column);
  ImGui::SetNextItemWidth(-FLT_MIN);
}

std::string number_text(int value, const std::string& unit) {
  return with_unit(std::to_string(value), unit_of(value, unit));
}

std::string number_text(float value, const std::string& unit) {
  return with_unit(fmt::format("{:.4g}", value), unit);
}

float room_in_field(float width) { return width - 2 * ImGui::GetStyle().FramePadding.x; }

bool number(const char* id, int& value, int low, int high, const std::string& unit) {
  const float speed = std::max(0.1f, 0.02f * static_cast<float>(std::abs(value)));
  const std::string format = field_format("%d", number_text(value, unit), unit_of(value, unit));
  const bool changed =
      ImGui::DragInt(id, &value, speed, low, high, format.c_str(), ImGuiSliderFlags_AlwaysClamp);
  explain_entering();
  return changed;
}

bool number(const char* id, float& value, float low, float high, const std::string& unit,
            bool logarithmic) {
  const float speed = std::max(1e-6f, 0.01f * std::abs(value));
  const auto flags =
      ImGuiSliderFlags_AlwaysClamp | (logarithmic ? ImGuiSliderFlags_Logarithmic : 0);
  const std::string format = field_format("%.4g", number_text(value, unit), unit);
  const bool changed = ImGui::DragFloat(id, &value, speed, low, high, format.c_str(), flags);
  explain_entering();
  return changed;
}

void readout(const char* label, const std::string& value, const std::string& help, float column) {
  row_label(label, help, column);
  const std::string shown = shortened(value, ImGui::GetContentRegionAvail().x);
  ImGui::TextUnformatted(shown.c_str());
  if (shown != value) tooltip(value);
}

void share_bar(const char* label, float share, const std::string& value, const std::string& help) {
  row_label(label, help);
  const Vec2 corner = from_imgui(ImGui::GetCursorScreenPos());
  const Vec2 size(ImGui::GetContentRegionAvail().x, ImGui::GetTextLineHeight());
  ImGui::Dummy(to_imgui(size));
  tooltip(help);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float rounding = scaled(3);
  list.AddRectFilled(to_imgui(corner), to_imgui(corner + size), palette::kField, rounding);
  const float filled = size.x * std::clamp(share, 0.0f, 1.0f);
  if (filled >= 1) {
    list.AddRectFilled(to_imgui(corner), to_imgui(corner + Vec2(filled, size.y)),
                       palette::kAccentSoft, rounding);
  }
  const std::string shown = shortened(value, size.x - scaled(8));
  const float left = size.x - text_width(shown) - scaled(5);
  list.AddText(to_imgui(corner + Vec2(left, 0)), palette::kText, shown.c_str());
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

bool close_lists() {
  if (ImGui::GetCurrentContext()->OpenPopupStack.empty() || ImGui::GetTopMostPopupModal()) {
    return false;
  }
  ImGui::ClosePopupToLevel(0, true);
  return true;
}

void tooltip(const std::string& text) {
  if (ImGui::IsItemActive() || !ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
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

void centered_text(ImDrawList& list, Vec2 center, ImU32 color, const std::string& text) {
  const Vec2 size = from_imgui(ImGui::CalcTextSize(text.c_str()));
  list.AddText(to_imgui(glm::round(center - 0.5f * size)), color, text.c_str());
}

void draw_note(ImDrawList& list, Vec2 corner, const std::string& text, ImU32 ground, ImU32 color) {
  const Vec2 pad(scaled(7), scaled(4));
  const float room = list.GetClipRectMax().x - list.GetClipRectMin().x - 2 * pad.x;
  const float wrap = std::max(1.0f, std::min(scaled(420), room));
  const Vec2 size = from_imgui(ImGui::CalcTextSize(text.c_str(), nullptr, false, wrap));
  const Vec2 lowest = from_imgui(list.GetClipRectMin()) + pad;
  const Vec2 highest = from_imgui(list.GetClipRectMax()) - size - 2.0f * pad;
  const Vec2 low = glm::max(glm::min(corner, highest), lowest);
  list.AddRectFilled(to_imgui(low - pad), to_imgui(low + size + pad), ground, scaled(4));
  list.AddText(ImGui::GetFont(), ImGui::GetFontSize(), to_imgui(low), color, text.c_str(), nullptr,
               wrap);
}

void draw_hint(ImDrawList& list, Vec2 center, const std::string& text) {
  const Vec2 half =
      0.5f * from_imgui(ImGui::CalcTextSize(text.c_str())) + Vec2(scaled(12), scaled(6));
  list.AddRectFilled(to_imgui(center - half), to_imgui(center + half), IM_COL32(20, 20, 20, 225),
                     scaled(8));
  centered_text(list, center, palette::kText, text);
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

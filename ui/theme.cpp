#include "ui/theme.h"

#include <array>
#include <cmath>
#include <filesystem>

namespace guidelight {
namespace {

ImVec4 color(ImU32 packed) { return ImGui::ColorConvertU32ToFloat4(packed); }

void set_colors(ImVec4* colors) {
  using namespace palette;
  colors[ImGuiCol_Text] = color(kText);
  colors[ImGuiCol_TextDisabled] = color(kDim);
  colors[ImGuiCol_TextSelectedBg] = color(kAccentSoft);
  colors[ImGuiCol_WindowBg] = color(kPanel);
  colors[ImGuiCol_ChildBg] = ImVec4(0, 0, 0, 0);
  colors[ImGuiCol_MenuBarBg] = color(kPanel);
  colors[ImGuiCol_PopupBg] = color(kRaised);
  colors[ImGuiCol_ModalWindowDimBg] = ImVec4(0, 0, 0, 0.45f);
  colors[ImGuiCol_Border] = color(kLine);
  colors[ImGuiCol_Separator] = color(kLine);
  colors[ImGuiCol_TitleBg] = colors[ImGuiCol_TitleBgActive] = color(kRaised);
  colors[ImGuiCol_FrameBg] = color(kField);
  colors[ImGuiCol_FrameBgHovered] = color(kFieldHovered);
  colors[ImGuiCol_FrameBgActive] = color(kFieldHovered);
  colors[ImGuiCol_Button] = color(kField);
  colors[ImGuiCol_ButtonHovered] = color(kFieldHovered);
  colors[ImGuiCol_ButtonActive] = color(kAccentSoft);
  colors[ImGuiCol_Tab] = color(kPanel);
  colors[ImGuiCol_TabHovered] = color(kFieldHovered);
  colors[ImGuiCol_TabActive] = color(kField);
  colors[ImGuiCol_TabUnfocused] = color(kPanel);
  colors[ImGuiCol_TabUnfocusedActive] = color(kField);
  colors[ImGuiCol_DragDropTarget] = color(kAccent);
  colors[ImGuiCol_PlotLines] = color(kAccent);
  colors[ImGuiCol_Header] = color(kAccentSoft);
  colors[ImGuiCol_HeaderHovered] = color(kFieldHovered);
  colors[ImGuiCol_HeaderActive] = color(kAccentSoft);
  colors[ImGuiCol_SliderGrab] = color(kAccentSoft);  // the value stays readable under it
  colors[ImGuiCol_SliderGrabActive] = color(kAccentSoft);
  colors[ImGuiCol_CheckMark] = color(kAccent);
  colors[ImGuiCol_PlotHistogram] = color(kAccent);
  colors[ImGuiCol_ScrollbarBg] = ImVec4(0, 0, 0, 0);
  colors[ImGuiCol_ScrollbarGrab] = color(kField);
  colors[ImGuiCol_ScrollbarGrabHovered] = color(kFieldHovered);
  colors[ImGuiCol_ScrollbarGrabActive] = color(kFieldHovered);
  colors[ImGuiCol_NavHighlight] = color(kAccent);
}

template <size_t N>
const char* first_existing(const std::array<const char*, N>& candidates) {
  for (const char* path : candidates) {
    if (std::filesystem::exists(path)) return path;
  }
  return nullptr;
}

constexpr std::array kBodyFonts = {
    "/usr/share/fonts/opentype/inter/Inter-Regular.otf",
    "/usr/share/fonts/truetype/inter/Inter-Regular.ttf",
    "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
};
constexpr std::array kHeadingFonts = {
    "/usr/share/fonts/opentype/inter/Inter-SemiBold.otf",
    "/usr/share/fonts/truetype/inter/Inter-SemiBold.ttf",
    "/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf",
};

constexpr ImWchar kDigits[] = {'0', '9', 0};
// Latin, Greek for symbols of the field, and the punctuation, arrows and mathematics that texts
// use.
constexpr ImWchar kOthers[] = {0x20,   0x2f,   0x3a,   0x17f,  0x391,  0x3c9,
                               0x2010, 0x2026, 0x2030, 0x203a, 0x2070, 0x209c,
                               0x2190, 0x2193, 0x2200, 0x22ff, 0};

void add_font(const char* path, float size) {
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  if (!path) {
    ImFontConfig own;
    own.SizePixels = size;
    atlas.AddFontDefault(&own);
    return;
  }
  // The figure eight is about as wide as a zero; 0.59 em holds both in Inter and in DejaVu Sans.
  ImFontConfig digits;
  digits.GlyphMinAdvanceX = digits.GlyphMaxAdvanceX = std::round(0.59f * size);
  atlas.AddFontFromFileTTF(path, size, &digits, kDigits);
  ImFontConfig others;
  others.MergeMode = true;
  atlas.AddFontFromFileTTF(path, size, &others, kOthers);
}

}  // namespace

void apply_theme(float scale) {
  ImGuiStyle style;
  style.WindowPadding = {14, 12};
  style.FramePadding = {9, 4};
  style.ItemSpacing = {8, 5};
  style.ItemInnerSpacing = {7, 5};
  style.CellPadding = {6, 3};
  style.IndentSpacing = 14;
  style.ScrollbarSize = 11;
  style.GrabMinSize = 11;
  style.WindowRounding = style.PopupRounding = 6;
  style.FrameRounding = style.GrabRounding = style.ChildRounding = 5;
  style.ScrollbarRounding = 5;
  style.WindowBorderSize = 0;
  style.ChildBorderSize = 0;
  style.PopupBorderSize = 1;
  style.FrameBorderSize = 0;
  style.WindowTitleAlign = {0, 0.5f};
  style.WindowMenuButtonPosition = ImGuiDir_None;
  style.DisabledAlpha = 0.45f;
  set_colors(style.Colors);
  style.ScaleAllSizes(scale);
  ImGui::GetStyle() = style;
}

void load_fonts(float scale) {
  ImGui::GetIO().Fonts->Clear();
  const float size = std::round(kBodySize * scale);
  add_font(first_existing(kBodyFonts), size);
  add_font(first_existing(kHeadingFonts), size);
}

ImFont* heading_font() { return ImGui::GetIO().Fonts->Fonts.back(); }

}  // namespace guidelight

#include "ui/panels/panels.h"

#include <gtest/gtest.h>
#include <imgui_internal.h>

#include "ui/format.h"
#include "ui/layout.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace guidelight {
namespace {

/// ImGui in the usual fonts at 1280×720, without a window of the system.
class WithoutWindow : public ::testing::Test {
 protected:
  void SetUp() override {
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = {1280, 720};
    load_fonts(1);
    io.Fonts->Build();
    apply_theme(1);
    ImGui::NewFrame();
  }
  void TearDown() override {
    ImGui::EndFrame();
    ImGui::DestroyContext();
  }
};

/// A panel of the usual width with a scroll bar.
class SettingsPanel : public WithoutWindow {
 protected:
  void SetUp() override {
    WithoutWindow::SetUp();
    const float scroll_bar = ImGui::GetStyle().ScrollbarSize;
    const Area area{{0, 0}, {Layout::kColumnWidth - scroll_bar, 720}};
    begin_area("panel", area, Padding::Panel, palette::kPanel);
    width_ = ImGui::GetContentRegionAvail().x;
  }
  void TearDown() override {
    ImGui::End();
    WithoutWindow::TearDown();
  }

  static float width_of(const std::string& text) { return ImGui::CalcTextSize(text.c_str()).x; }

  float width_ = 0;  // of what is in the panel
};

/// The widest text that a parameter's field shows when it has its default.
std::string widest_text(const Parameter& parameter) {
  if (const auto whole = std::get_if<int*>(&parameter.value)) {
    return number_text(**whole, parameter.unit);
  }
  if (const auto real = std::get_if<float*>(&parameter.value)) {
    return number_text(**real, parameter.unit);
  }
  std::string widest;
  if (const auto choice = std::get_if<Parameter::Choice>(&parameter.value)) {
    for (const std::string& name : choice->names) {
      if (name.size() > widest.size()) widest = choice_text(name);
    }
  }
  return widest;
}

TEST_F(SettingsPanel, EveryLabelAndEveryDefaultOfEveryAlgorithmFits) {
  for (const IntegratorInfo& info : integrators()) {
    SCOPED_TRACE(info.name);
    const auto settings = info.make_settings({});
    const std::vector<Parameter> parameters = settings->parameters();
    const float column = settings_column(parameters);
    for (const Parameter& parameter : parameters) {
      SCOPED_TRACE(parameter.key);
      EXPECT_LE(width_of(parameter.label), column - ImGui::GetStyle().ItemInnerSpacing.x);
      const bool is_list = std::holds_alternative<Parameter::Choice>(parameter.value);
      const float arrow = is_list ? ImGui::GetFrameHeight() : 0;
      EXPECT_LE(width_of(widest_text(parameter)), room_in_field(width_ - column) - arrow)
          << widest_text(parameter);
    }
  }
}

TEST_F(SettingsPanel, EveryAlgorithmsNameFits) {
  for (const IntegratorInfo& info : integrators()) {
    EXPECT_LE(width_of(info.label), room_in_field(width_) - ImGui::GetFrameHeight()) << info.label;
  }
}

TEST_F(SettingsPanel, ThreeValuesFitBesideTheirLabel) {
  constexpr float kLabelShare = 0.35f;
  for (const Vec3 values :
       {Vec3(-0.8888f, -0.8888f, -0.8888f), Vec3(-88.88f, -88.88f, -88.88f), Vec3(8888),
        Vec3(8.88e-12f), Vec3(8.88e15f), Vec3(0.0008f, 0.08f, 0.8f)}) {
    const std::string text = format_triple(values);
    EXPECT_LE(width_of(text), (1 - kLabelShare) * width_) << text;
  }
}

using KeySheet = WithoutWindow;

TEST_F(KeySheet, FitsIntoTheSmallestWindowWithoutScrolling) {
  bool open = true;
  for (int frame = 0; frame < 3; ++frame) {  // ImGui learns how large it is
    draw_key_sheet(open);
    ImGui::EndFrame();
    ImGui::NewFrame();
  }
  const ImGuiWindow* sheet = ImGui::FindWindowByName("Keys");
  ASSERT_TRUE(sheet);
  EXPECT_GT(sheet->ContentSize.y, 400) << "the keys";
  EXPECT_LE(sheet->Size.x, 1280);
  EXPECT_LE(sheet->Size.y, 720);
  EXPECT_EQ(sheet->ScrollMax.x, 0);
  EXPECT_EQ(sheet->ScrollMax.y, 0);
}

/// Whether a parameter of an algorithm says that it has no effect.
bool is_unused(IntegratorSettings& settings, const std::string& key) {
  for (const Parameter& parameter : settings.parameters()) {
    if (parameter.key == key) return !parameter.unused.empty();
  }
  ADD_FAILURE() << "there is no parameter " << key;
  return false;
}

TEST(UnusedParameters, SayThatOthersLeaveThemWithoutEffect) {
  struct Case {
    const char* integrator;
    const char* key;
    const char* decided_by;
    const char* used;
    const char* unused;
  };
  for (const Case& each :
       {Case{"sppm", "scene_radius", "radius_from", "scene", "pixel"},
        Case{"sppm", "pixel_radius", "radius_from", "pixel", "scene"},
        Case{"vcm", "scene_radius", "merging", "true", "false"},
        Case{"bdpt", "connect_to", "connections", "true", "false"},
        Case{"bdpt", "random_vertices", "connect_to", "random_vertices", "own_path"},
        Case{"mlt", "direct_samples", "separate_direct", "true", "false"},
        Case{"mlt", "direct_samples", "min_length", "1", "3"},
        Case{"mps", "cache_accuracy", "irradiance_cache", "true", "false"}}) {
    SCOPED_TRACE(std::string(each.integrator) + " " + each.key);
    const auto settings = find_integrator(each.integrator).make_settings({});
    set_parameter(*settings, each.decided_by, each.used);
    EXPECT_FALSE(is_unused(*settings, each.key));
    set_parameter(*settings, each.decided_by, each.unused);
    EXPECT_TRUE(is_unused(*settings, each.key));
  }
}

}  // namespace
}  // namespace guidelight

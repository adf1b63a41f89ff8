#include <fmt/format.h>

#include <algorithm>
#include <thread>

#include "ui/panels/panels.h"
#include "ui/widgets.h"

namespace guidelight {
namespace {

constexpr int kMaxSide = 16384;  // [pixels] of a picture

/// Shares of the scene's own size.
bool edit_size(const Scene& scene, RenderSettings& settings, float column) {
  const int width = scene.camera().width();
  const int height = scene.camera().height();
  bool changed = false;
  row("Size", "Of the picture in pixels. Changing it restarts the render.", column);
  const std::string shown = fmt::format("{} × {}", settings.width, settings.height);
  if (!ImGui::BeginCombo("##size", shown.c_str())) return false;
  for (const int percent : {25, 50, 100, 200}) {
    const int scaled_width = std::clamp(width * percent / 100, 1, kMaxSide);
    const int scaled_height = std::clamp(height * percent / 100, 1, kMaxSide);
    const std::string label = fmt::format("{} × {}   {} %", scaled_width, scaled_height, percent);
    const bool chosen = scaled_width == settings.width && scaled_height == settings.height;
    if (ImGui::Selectable(label.c_str(), chosen) && !chosen) {
      settings.width = scaled_width;
      settings.height = scaled_height;
      changed = true;
    }
  }
  ImGui::EndCombo();
  return changed;
}

bool edit_threads(RenderSettings& settings, float column) {
  const int all = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  int threads = settings.threads > 0 ? settings.threads : all;
  row("Threads",
      "Render threads; the window comes first on all of them. Changing it restarts the render.",
      column);
  const char* note = settings.threads == 0 ? "(all)" : "";
  if (!number("##threads", threads, 1, std::max(all, settings.threads), note)) return false;
  settings.threads = threads == all ? 0 : threads;
  return true;
}

bool edit_seed(RenderSettings& settings, float column) {
  row("Seed", "The same seed gives the same picture. Changing it restarts the render.", column);
  const uint64_t step = 1;
  return ImGui::InputScalar("##seed", ImGuiDataType_U64, &settings.seed, &step);
}

bool edit_targets(RenderTargets& targets, float column) {
  const std::string no_limit = " 0 sets no limit. Changing it does not restart the render.";
  bool changed = false;

  int passes = static_cast<int>(targets.passes);
  row("Stop after", "Passes to render, one sample per pixel each." + no_limit, column);
  if (number("##passes", passes, 0, 1 << 24, passes == 0 ? "(no limit)" : "passes")) {
    targets.passes = static_cast<uint32_t>(passes);
    changed = true;
  }
  int seconds = static_cast<int>(targets.seconds);
  row("or after", "Seconds of rendering, pauses excluded." + no_limit, column);
  if (number("##seconds", seconds, 0, 1 << 24, seconds == 0 ? "s (no limit)" : "s")) {
    targets.seconds = seconds;
    changed = true;
  }
  auto percent = static_cast<float>(100 * targets.relative_error);
  row("or at error", "Estimated relative error of a pixel, mean over the picture." + no_limit,
      column);
  if (number("##error", percent, 0, 100, percent == 0 ? "% (no limit)" : "%")) {
    targets.relative_error = percent / 100;
    changed = true;
  }
  return changed;
}

void edit_autosave(int& minutes, float column) {
  row("Autosave",
      "Minutes between checkpoints that are saved while rendering, beside the pictures. 0: never.",
      column);
  number("##autosave", minutes, 0, 24 * 60, minutes == 0 ? "min (never)" : "min");
}

}  // namespace

void draw_render_commands(const Document& document, bool region_tool_active,
                          const Perform& perform) {
  if (!document.has_scene()) return;
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const float width = (ImGui::GetContentRegionAvail().x - 2 * gap) / 3;
  const auto explain = [](Action action) {
    tooltip(fmt::format("{} ({})", action_label(action), shortcut_text(action)));
  };
  const char* label = document.paused() ? "Resume" : "Pause";
  if (toggle_button(label, document.paused(), {width, 0})) perform(Action::PauseResume);
  explain(Action::PauseResume);
  ImGui::SameLine();
  if (ImGui::Button("Restart", {width, 0})) perform(Action::Restart);
  explain(Action::Restart);
  ImGui::SameLine();
  const bool region = document.settings().region.has_value();
  if (toggle_button("Region", region || region_tool_active, {width, 0})) {
    perform(region ? Action::ClearRegion : Action::RegionTool);
  }
  explain(region ? Action::ClearRegion : Action::RegionTool);
}

void draw_render_panel(Document& document, int& autosave_minutes, float column) {
  if (!document.has_scene() || !section("Render")) return;
  RenderSettings settings = document.settings();
  bool changed = edit_size(document.scene(), settings, column);
  changed |= edit_threads(settings, column);
  changed |= edit_seed(settings, column);
  changed |= edit_targets(settings.targets, column);
  if (changed) document.set_settings(settings);
  edit_autosave(autosave_minutes, column);
}

}  // namespace guidelight

#include <fmt/format.h>

#include <algorithm>

#include "ui/format.h"
#include "ui/panels/panels.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace guidelight {
namespace {

void draw_swatch(Color color, const std::string& text) {
  const Vec2 corner = from_imgui(ImGui::GetCursorScreenPos());
  const float line = ImGui::GetTextLineHeight();
  ImGui::GetWindowDrawList()->AddCircleFilled(to_imgui(corner + Vec2(scaled(6), line / 2)),
                                              scaled(4), to_imgui_color(color));
  ImGui::Dummy({scaled(14), line});
  ImGui::SameLine(0, scaled(4));
  dim_text(text);
}

/// Bars in the colours that the photons have, with the ends of the axis below.
void draw_power_histogram(const PowerHistogram& powers) {
  const float tallest = *std::ranges::max_element(powers.counts);
  if (!(tallest > 0)) return;
  const Vec2 corner = from_imgui(ImGui::GetCursorScreenPos());
  const Vec2 size(ImGui::GetContentRegionAvail().x, scaled(70));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(to_imgui(corner), to_imgui(corner + size), palette::kBackdrop, scaled(4));
  const float width = size.x / PowerHistogram::kBins;
  for (int i = 0; i < PowerHistogram::kBins; ++i) {
    const float share = (static_cast<float>(i) + 0.5f) / PowerHistogram::kBins;
    const Color color = color_map(ColorMap::Turbo, share);
    const float height = powers.counts[i] / tallest * (size.y - scaled(4));
    const Vec2 low = corner + Vec2(width * static_cast<float>(i), size.y - height);
    list.AddRectFilled(to_imgui(low), to_imgui(low + Vec2(width, height)), to_imgui_color(color));
  }
  ImGui::Dummy(to_imgui(size));
  tooltip("How many photons have which power; the axis is logarithmic");
  dim_text(format_value(powers.low) + " W");
  const std::string high = format_value(powers.high) + " W";
  ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - ImGui::CalcTextSize(high.c_str()).x);
  dim_text(high);
}

void draw_key(PhotonColoring coloring, const PowerHistogram& powers) {
  switch (coloring) {
    case PhotonColoring::Power:
      draw_power_histogram(powers);
      break;
    case PhotonColoring::Bounce:
      for (int bounce = 1; bounce <= kBounceColors; ++bounce) {
        const bool last = bounce == kBounceColors;
        draw_swatch(bounce_color(bounce),
                    last ? fmt::format("{} segments and more", bounce)
                         : fmt::format("{} segment{}", bounce, bounce == 1 ? "" : "s"));
      }
      break;
    case PhotonColoring::Kind:
      draw_swatch(kind_color(false), "global");
      draw_swatch(kind_color(true), "caustic: specular surfaces only on the way");
      break;
  }
}

void draw_cloud(const PhotonCloud& cloud) {
  const size_t shown = cloud.points.size();
  readout("Photons", format_count(static_cast<double>(cloud.total)), "Stored in the last pass");
  readout("Shown",
          cloud.total == 0 ? "none"
                           : fmt::format("{} ({})", format_count(static_cast<double>(shown)),
                                         format_percent(static_cast<double>(shown) /
                                                        static_cast<double>(cloud.total))),
          "Evenly chosen among all");
  readout("Memory", format_bytes(cloud.bytes), "That all photons of the pass take");
}

}  // namespace

void draw_photons_panel(Document& document, const PowerHistogram& powers) {
  if (!section("Photons")) return;
  PhotonView view = document.photon_view();
  row("Show", fmt::format("In both views ({})", shortcut_text(Action::ShowPhotons)));
  bool changed = ImGui::Checkbox("Photons##shown", &view.shown);
  if (view.shown) {
    row("Colour", "What the colours of photons stand for");
    int coloring = static_cast<int>(view.coloring);
    if (ImGui::Combo("##coloring", &coloring, "Power\0Bounce\0Kind\0")) {
      view.coloring = static_cast<PhotonColoring>(coloring);
      changed = true;
    }
    row("Size", "Diameter on the screen");
    changed |= number("##size", view.point_size, 1, 12, "px");
    row("At most", "Photons to draw. A few ten thousand keep the window quick.");
    changed |= number("##cap", view.cap, 100, 2'000'000, "photons");
  }
  if (changed) document.set_photon_view(view);
  if (!view.shown) return;
  const auto& picture = document.picture();
  if (!picture || !picture->photons) {
    wrapped_dim_text(
        "The algorithm has stored none yet. Photon mapping, progressive photon mapping, merging "
        "(BDPM, VCM) and Metropolis photon sampling store photons; the path tracer does not.");
    return;
  }
  draw_cloud(*picture->photons);
  draw_key(view.coloring, powers);
}

}  // namespace guidelight

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

/// Bars with the ends of the axis below, in the colours that the photons have if that is what their
/// colours mean.
void draw_power_histogram(const PowerHistogram& powers, bool colored) {
  const float tallest = *std::ranges::max_element(powers.counts);
  if (!(tallest > 0)) return;
  const Vec2 corner = from_imgui(ImGui::GetCursorScreenPos());
  const Vec2 size(ImGui::GetContentRegionAvail().x, scaled(70));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(to_imgui(corner), to_imgui(corner + size), palette::kBackdrop, scaled(4));
  const float width = size.x / PowerHistogram::kBins;
  for (int i = 0; i < PowerHistogram::kBins; ++i) {
    const float share = (static_cast<float>(i) + 0.5f) / PowerHistogram::kBins;
    const ImU32 color = colored ? to_imgui_color(color_map(ColorMap::Turbo, share)) : palette::kDim;
    const float height = powers.counts[i] / tallest * (size.y - scaled(4));
    const Vec2 low = corner + Vec2(width * static_cast<float>(i), size.y - height);
    list.AddRectFilled(to_imgui(low), to_imgui(low + Vec2(width, height)), color);
  }
  ImGui::Dummy(to_imgui(size));
  tooltip("How many photons have which power; the axis is logarithmic");
  dim_text(format_value(powers.low) + " W");
  const std::string high = format_value(powers.high) + " W";
  ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - ImGui::CalcTextSize(high.c_str()).x);
  dim_text(high);
}

/// The guides in the order of their shares.
void draw_guide_key(const std::vector<GuideShare>& shares, const std::vector<GuidePath>& guides) {
  for (const GuideShare& share : shares) {
    const bool is_listed = share.guide >= 0 && static_cast<size_t>(share.guide) < guides.size();
    const std::string name = is_listed          ? guides[share.guide].name
                             : share.guide >= 0 ? "a guide that is gone"
                                                : "no guide";
    draw_swatch(guided_color(share.guide, guides), format_percent(share.share) + "  " + name);
  }
}

void draw_key(PhotonColoring coloring, const DisplayScene& display,
              const std::vector<GuidePath>& guides) {
  switch (coloring) {
    case PhotonColoring::Power:
      break;  // the histogram's
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
    case PhotonColoring::Guide:
      draw_guide_key(display.guide_shares(), guides);
      break;
  }
}

double guided_share(const std::vector<GuideShare>& shares) {
  double sum = 0;
  for (const GuideShare& share : shares) sum += share.guide >= 0 ? share.share : 0;
  return sum;
}

void draw_cloud(const PhotonCloud& cloud, const std::vector<GuideShare>& shares) {
  const size_t shown = cloud.points.size();
  readout("Photons", format_count(static_cast<double>(cloud.total)), "Stored in the last pass");
  readout(
      "Shown",
      fmt::format("{} ({})", format_count(static_cast<double>(shown)),
                  format_percent(static_cast<double>(shown) / static_cast<double>(cloud.total))),
      "Evenly chosen among all");
  readout("Memory", format_bytes(cloud.bytes), "That all photons of the pass take");
  const double guided = guided_share(shares);
  share_bar("Guided", static_cast<float>(guided), format_percent(guided),
            "Share of the photons whose light path began with a guide. Metropolis chains mix "
            "guides with other mutations, so their photons belong to none.");
}

bool edit_view(PhotonView& view) {
  row("As", "What is drawn in the views");
  const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
  const float width = (ImGui::GetContentRegionAvail().x - gap) / 2;
  const auto toggle = [&](const char* label, bool& on, const char* help) {
    const bool pressed = toggle_button(label, on, {width, 0});
    tooltip(help);
    if (pressed) on = !on;
    return pressed;
  };
  bool changed = toggle("Points", view.points, "Each photon, coloured as below");
  ImGui::SameLine(0, gap);
  changed |= toggle("Density", view.density, "Photons per area of the surfaces, as colours");
  row("Colour", "What the colours of points stand for");
  int coloring = static_cast<int>(view.coloring);
  if (ImGui::Combo("##coloring", &coloring, "Power\0Bounce\0Kind\0Guide\0")) {
    view.coloring = static_cast<PhotonColoring>(coloring);
    changed = true;
  }
  row("Size", "Diameter of points on the screen");
  changed |= number("##size", view.point_size, 1, 12, "px");
  row("At most", "Photons to draw. A few ten thousand keep the window quick.");
  changed |= number("##cap", view.cap, 100, 2'000'000, "photons");
  return changed;
}

}  // namespace

void draw_photons_panel(Document& document, const DisplayScene& display) {
  if (!section("Photons")) return;
  PhotonView view = document.photon_view();
  row("Show", fmt::format("In both views ({})", shortcut_text(Action::ShowPhotons)));
  bool changed = ImGui::Checkbox("Photons##shown", &view.shown);
  if (view.shown) changed |= edit_view(view);
  if (changed) document.set_photon_view(view);
  if (!view.shown) return;
  const auto& picture = document.picture();
  if (!picture || !picture->photons) {
    wrapped_dim_text("They are shown after the next pass.");
    return;
  }
  if (picture->photons->total == 0) {
    wrapped_dim_text(find_integrator(document.picture_job().integrator).label +
                     " has stored none in its last pass. Photon mapping, progressive photon "
                     "mapping, merging (BDPM, VCM) and Metropolis photon sampling store photons.");
    return;
  }
  draw_cloud(*picture->photons, display.guide_shares());
  draw_key(view.coloring, display, *document.guides());
  if (section("Power of photons")) {
    draw_power_histogram(display.powers(), view.coloring == PhotonColoring::Power);
  }
}

}  // namespace guidelight

#include <fmt/format.h>

#include "ui/format.h"
#include "ui/panels/panels.h"
#include "ui/pixel_probe.h"
#include "ui/plot.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace guidelight {
namespace {

/// A row for three values; its tooltip has each with all its digits.
void readout_triple(const char* label, Vec3 v, const std::string& help) {
  readout(label, format_triple(v), fmt::format("{}: {:.6g}, {:.6g}, {:.6g}", help, v.x, v.y, v.z));
}

std::string error_text(const PixelReport& report) {
  if (report.samples < 2) return "unknown yet";
  const float value = luminance(report.radiance);
  const std::string absolute = "± " + format_value(report.standard_error);
  if (!(value > 0)) return absolute;
  return absolute + "  (" + format_percent(report.standard_error / value) + ")";
}

void draw_values(const PixelReport& report) {
  readout_triple("Radiance", report.radiance, "Red, green, blue [W/(m² sr)]");
  readout("Luminance", format_value(luminance(report.radiance)), "Rec. 709 [W/(m² sr)]");
  readout("Error", error_text(report),
          "Standard error of the luminance, estimated from the samples");
  readout("Samples", format_count(report.samples), "Camera paths through this pixel");
}

/// What the pixel's light is made of, and by which techniques it was found.
void draw_contributions(const PixelReport& report) {
  const float whole = luminance(report.radiance);
  if (!(whole > 0)) return;
  const auto part = [&](const char* label, Color radiance, const std::string& what) {
    const float share = luminance(radiance) / whole;
    share_bar(label, share, format_percent(share),
              what + ": " + format_triple(radiance) + " W/(m² sr)");
  };
  dim_text("What its light is made of");
  part("Direct", report.direct, "Lights that are seen, and light after one scattering");
  part("Caustic", report.caustic, "Focused by mirrors and glass");
  part("Other", report.indirect - report.caustic, "All other indirect light");
  dim_text("How it was found");
  part("Connected", report.connection, "By tracing and connecting paths");
  part("Merged", report.merging, "By merging vertices, which is density estimation");
}

/// What guides have to do with it, of the methods that know.
void draw_guided_share_of(const Snapshot& picture) {
  if (!picture.chains || picture.chains->guides.empty()) return;
  double found = 0;
  for (const ProposalStatistics& guide : picture.chains->guides) found += guide.contribution;
  share_bar("By guides", static_cast<float>(found), format_percent(found),
            "Share of the chains' light that guide paths have found, in the whole picture");
}

void draw_surface(const PixelReport& report) {
  if (!report.seen) {
    readout("Sees", "nothing: the ray leaves the scene");
    return;
  }
  const SeenSurface& seen = *report.seen;
  const std::string shape = seen.shape.empty() ? "unnamed shape" : seen.shape;
  const std::string bsdf = seen.bsdf.empty() ? "unnamed" : seen.bsdf;
  readout("Sees", seen.emits ? shape + " (light)" : shape,
          "The shape hit through the pixel's middle");
  readout("BSDF", bsdf);
  readout_triple("Position", seen.position, "In world space [scene units]");
  readout("Depth", format_value(report.depth), "Mean distance from the camera [scene units]");
  readout_triple("Normal", report.normal, "In world space, mean over the samples");
  readout_triple("Albedo", report.albedo, "Share of red, green and blue light that is reflected");
}

/// For progressive density estimates: radius, count and estimate over the light paths.
void draw_history(const std::vector<PixelHistory::Entry>& history) {
  if (history.empty()) return;
  const auto plot = [&](const char* title, const char* id, bool logarithmic, auto value) {
    PlotCurve curve{"", palette::kAccent, {}};
    for (const PixelHistory::Entry& entry : history) {
      curve.points.emplace_back(static_cast<float>(entry.emitted), value(entry));
    }
    dim_text(title);
    draw_plot(id, {&curve, 1}, {"paths", "", true, logarithmic});
  };
  plot("Radius over light paths [scene units]", "radius", true,
       [](const auto& entry) { return entry.radius; });
  plot("Photons that count, over light paths", "count", true,
       [](const auto& entry) { return entry.count; });
  plot("Estimate of the luminance", "estimate", false,
       [](const auto& entry) { return luminance(entry.estimate); });
}

}  // namespace

void draw_inspector_panel(Document& document) {
  if (!section("Inspector")) return;
  const auto picked = document.view().inspected_pixel;
  const auto pixel = picked ? picked : document.view().hovered_pixel;
  const auto scene = pixel ? document.current_scene() : nullptr;
  const auto picture = document.picture();
  const auto report = scene && picture ? probe_pixel(*scene, *picture, pixel->x, pixel->y)
                                       : std::optional<PixelReport>();
  if (!report) {
    wrapped_dim_text("Point at the picture; click to keep a pixel.");
    return;
  }
  readout("Pixel", fmt::format("{}, {}", report->x, report->y), "From the upper left corner");
  if (picked) {
    const float width = ImGui::CalcTextSize("release").x + 2 * ImGui::GetStyle().FramePadding.x;
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - width);
    if (ImGui::SmallButton("release")) document.view().inspected_pixel.reset();
  }
  draw_values(*report);
  draw_contributions(*report);
  draw_guided_share_of(*picture);
  draw_surface(*report);
  if (picked) draw_history(document.pixel_history(*picked));
}

}  // namespace guidelight

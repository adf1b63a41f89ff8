#include <fmt/format.h>

#include <filesystem>

#include "ui/format.h"
#include "ui/panels/panels.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace guidelight {
namespace {

void draw_warnings(const std::vector<std::string>& warnings) {
  if (warnings.empty()) return;
  ImGui::PushStyleColor(ImGuiCol_Text, palette::kWarning);
  const std::string label =
      fmt::format("{} warning{}", warnings.size(), warnings.size() == 1 ? "" : "s");
  const bool open = ImGui::TreeNode("warnings", "%s", label.c_str());
  ImGui::PopStyleColor();
  if (!open) return;
  for (const std::string& warning : warnings) wrapped_dim_text(warning);
  ImGui::TreePop();
}

}  // namespace

void draw_scene_panel(const Document& document, float column) {
  if (!section("Scene")) return;
  if (!document.has_scene()) {
    wrapped_dim_text("None is open. Scenes are Mitsuba XML or glTF 2.0 files.");
    return;
  }
  const Scene& scene = document.scene();
  const Scene::Statistics statistics = scene.statistics();
  const std::filesystem::path file(document.opened().path);
  const auto show = [column](const char* label, const std::string& value,
                             const std::string& help = "") { readout(label, value, help, column); };
  show("File", (file.parent_path().filename() / file.filename()).string());
  tooltip(document.opened().path);
  show("Shapes", format_count(static_cast<double>(statistics.shapes)));
  show("Triangles", format_count(static_cast<double>(statistics.triangles)));
  if (statistics.instances > 0) {
    show("Instances", format_count(static_cast<double>(statistics.instances)));
  }
  show("Lights", format_count(static_cast<double>(statistics.lights)));
  show("Memory", format_bytes(statistics.bytes), "Geometry, its search structure and textures");
  draw_warnings(scene.description().warnings);
}

}  // namespace guidelight

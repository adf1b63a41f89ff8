#include "ui/figure.h"

#include <fmt/format.h>

#include <algorithm>

#include "ui/format.h"
#include "ui/gl/offscreen.h"
#include "ui/label_placer.h"
#include "ui/overlays/guide_overlay.h"
#include "ui/picture_texture.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace guidelight {
namespace {

constexpr float kLongSide = 1280;  // that pictures are enlarged to [pixels]
constexpr int kLargest = 8;        // times

/// A figure under construction.
class Figure {
 public:
  Figure(const Document& document, const Picture& picture)
      : document_(document),
        picture_(picture),
        scene_(*picture.job->scene),
        factor_(enlargement(picture.snapshot->full_width, picture.snapshot->full_height)),
        picture_size_(factor_ * Vec2(picture.snapshot->full_width, picture.snapshot->full_height)) {
    const auto& solo = document.guide_view().solo;
    for (size_t i = 0; i < document.guides()->size(); ++i) {
      const bool followed = solo ? *solo == i : (*document.guides())[i].enabled;
      if (followed && document.guide_faults(i).empty()) shown_.push_back(i);
    }
    texture_.upload(picture.image);
    texture_.set_smooth(factor_ > 1);
  }

  DisplayImage paint() {
    const Vec2 size = picture_size_ + Vec2(0, legend_height());
    return paint_offscreen(static_cast<int>(size.x), static_cast<int>(size.y), palette::kBackdrop,
                           [&](ImDrawList& list) {
                             list.AddImage(texture_.id(), {0, 0}, to_imgui(picture_size_));
                             draw_paths(list);
                             draw_caption(list);
                             draw_legend_rows(list);
                           });
  }

 private:
  static float enlargement(int width, int height) {
    const float longest = static_cast<float>(std::max({width, height, 1}));
    return std::clamp(std::ceil(kLongSide / longest), 1.0f, static_cast<float>(kLargest));
  }

  const GuidePath& guide(size_t i) const { return (*document_.guides())[shown_[i]]; }

  void draw_paths(ImDrawList& list) const {
    const ViewProjection projection =
        project_scene(scene_.camera(), Vec2(0), factor_, scene_.bounds());
    const ToolView view{projection, nullptr};
    list.PushClipRect({0, 0}, to_imgui(picture_size_), true);
    LabelPlacer labels(picture_size_);
    for (size_t i = 0; i < shown_.size(); ++i) draw_plain_guide(document_, shown_[i], view, list);
    for (size_t i = 0; i < shown_.size(); ++i) draw_name(guide(i), projection, labels, list);
    list.PopClipRect();
  }

  /// Beside the last vertex that the picture shows.
  void draw_name(const GuidePath& guide, const ViewProjection& projection, LabelPlacer& labels,
                 ImDrawList& list) const {
    for (auto vertex = guide.vertices.rbegin(); vertex != guide.vertices.rend(); ++vertex) {
      const auto place = projection.to_screen(vertex->position);
      const bool inside = place && glm::all(glm::greaterThanEqual(*place, Vec2(0))) &&
                          glm::all(glm::lessThan(*place, picture_size_));
      if (!inside) continue;
      const Vec2 pad(scaled(7), scaled(3));
      const Vec2 size = from_imgui(ImGui::CalcTextSize(guide.name.c_str())) + 2.0f * pad;
      const Vec2 corner = glm::round(labels.place(*place, size, scaled(9)));
      list.AddRectFilled(to_imgui(corner), to_imgui(corner + size), IM_COL32(20, 20, 20, 215),
                         scaled(4));
      list.AddText(to_imgui(corner + pad), to_imgui_color(guide.color), guide.name.c_str());
      return;
    }
  }

  // -- Below the picture.

  static float margin() { return scaled(14); }
  static float row_height() { return ImGui::GetTextLineHeight() + scaled(8); }
  int columns() const {
    return std::max(1, static_cast<int>((picture_size_.x - 2 * margin()) / scaled(400)));
  }
  float legend_height() const {
    const auto rows = (shown_.size() + columns() - 1) / columns();
    return 2 * margin() + row_height() * static_cast<float>(1 + rows) - scaled(8);
  }

  std::string caption() const {
    const Snapshot& snapshot = *picture_.snapshot;
    const std::string progress =
        snapshot.passes == 0
            ? "preview"
            : fmt::format("{} pass{} in {}", snapshot.passes, snapshot.passes == 1 ? "" : "es",
                          format_duration(snapshot.seconds));
    return fmt::format("{}  ·  {}  ·  {}", document_.title(),
                       find_integrator(picture_.job->integrator).label, progress);
  }

  void draw_caption(ImDrawList& list) const {
    const Vec2 corner = Vec2(0, picture_size_.y) + margin();
    const float room = picture_size_.x - 2 * margin();
    list.AddText(to_imgui(corner), palette::kText, shortened(caption(), room).c_str());
  }

  void draw_legend_rows(ImDrawList& list) const {
    double total = 0;
    for (size_t i = 0; i < shown_.size(); ++i) total += guide(i).weight;
    const float width = (picture_size_.x - 2 * margin()) / static_cast<float>(columns());
    for (size_t i = 0; i < shown_.size(); ++i) {
      const Vec2 cell(static_cast<float>(i % columns()), 1 + static_cast<float>(i / columns()));
      const Vec2 corner = Vec2(0, picture_size_.y) + margin() + cell * Vec2(width, row_height());
      draw_legend_entry(guide(i), total > 0 ? guide(i).weight / total : 0, corner, width, list);
    }
  }

  static void draw_legend_entry(const GuidePath& guide, double share, Vec2 corner, float width,
                                ImDrawList& list) {
    const ImU32 color = to_imgui_color(guide.color);
    const float middle = corner.y + 0.5f * ImGui::GetTextLineHeight();
    const float sample = scaled(26);
    list.AddLine({corner.x + scaled(4), middle}, {corner.x + sample - scaled(4), middle}, color,
                 scaled(2));
    for (const float x : {scaled(4), sample - scaled(4)}) {
      list.AddCircleFilled({corner.x + x, middle}, scaled(3.5f), color);
    }
    const std::string details = fmt::format("{} of guided paths, {} vertices",
                                            format_percent(share), guide.vertices.size());
    const float gap = scaled(8);
    const float room = width - sample - 3 * gap - ImGui::CalcTextSize(details.c_str()).x;
    const std::string name = shortened(guide.name, std::max(room, scaled(60)));
    const float text = corner.x + sample + gap;
    list.AddText({text, corner.y}, palette::kText, name.c_str());
    list.AddText({text + ImGui::CalcTextSize(name.c_str()).x + gap, corner.y}, palette::kDim,
                 details.c_str());
  }

  const Document& document_;
  const Picture& picture_;
  const Scene& scene_;
  float factor_;  // screen pixels per pixel
  Vec2 picture_size_;
  std::vector<size_t> shown_;  // guides
  PictureTexture texture_;
};

}  // namespace

DisplayImage paint_figure(const Document& document, const Picture& picture) {
  return Figure(document, picture).paint();
}

}  // namespace guidelight

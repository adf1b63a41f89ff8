#include "ui/render_view.h"

#include "ui/legend.h"
#include "ui/overlays/scene_overlays.h"
#include "ui/theme.h"
#include "ui/tools/region_tool.h"
#include "ui/widgets.h"

namespace guidelight {

void RenderView::show(std::shared_ptr<const Picture> picture) {
  picture_ = std::move(picture);
  if (picture_) texture_.upload(picture_->image);
}

void RenderView::draw(Document& document, Toolbox& toolbox) {
  const Vec2 corner = from_imgui(ImGui::GetCursorScreenPos());
  const Vec2 room = glm::max(from_imgui(ImGui::GetContentRegionAvail()), Vec2(1));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (!document.has_scene()) {
    const std::string invitation =
        "Drop a scene here, or press " + shortcut_text(Action::OpenScene);
    centered_text(list, corner + 0.5f * room, palette::kDim, invitation);
    return;
  }
  transform_.set_room(corner, room, Vec2(document.settings().width, document.settings().height));
  ImGui::InvisibleButton("picture", to_imgui(room),
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                             ImGuiButtonFlags_MouseButtonMiddle);
  const bool hovered = ImGui::IsItemHovered();
  find_hovered_pixel(document, hovered);
  list.PushClipRect(to_imgui(corner), to_imgui(corner + room), true);
  draw_picture(list);
  draw_scene_overlays(document, toolbox, list, corner, room, hovered);
  list.PopClipRect();
}

void RenderView::draw_picture(ImDrawList& list) {
  if (!picture_ || texture_.empty()) return;
  const Vec2 size(picture_->snapshot->full_width, picture_->snapshot->full_height);
  const float texel = transform_.scale() * size.x / static_cast<float>(picture_->image.width);
  texture_.set_smooth(picture_->snapshot->coarse || (texel != 1 && texel < 2));
  list.AddImage(texture_.id(), to_imgui(transform_.to_screen(Vec2(0))),
                to_imgui(transform_.to_screen(size)));
}

void RenderView::draw_scene_overlays(Document& document, Toolbox& toolbox, ImDrawList& list,
                                     Vec2 corner, Vec2 room, bool hovered) {
  const auto scene = document.current_scene();
  const ViewProjection projection = project_scene(scene->camera(), transform_.to_screen(Vec2(0)),
                                                  transform_.scale(), scene->bounds());
  ToolView view{projection, &transform_};
  view.mouse = from_imgui(ImGui::GetMousePos());
  const RenderSettings& settings = document.settings();
  NavigationTarget target;
  target.move = [&](const auto& move) { document.move_camera(move); };
  target.find_pivot = [&] { document.find_pivot(); };
  target.picture = &transform_;
  target.room = room;
  target.picture_height = transform_.scale() * static_cast<float>(settings.height);
  mouse_.update(document, toolbox, view, target, hovered);

  if (settings.region) draw_region(*settings.region, settings, transform_, list);
  draw_overlays(document, view, list);
  toolbox.tool().draw(document, view, list);
  if (picture_ && picture_->display.curve == ToneCurve::FalseColor) {
    draw_legend(list, corner + room, *picture_);
  }
  const std::string hint = toolbox.tool().hint();
  if (!hint.empty()) draw_hint(list, corner + Vec2(room.x / 2, room.y - scaled(32)), hint);
}

void RenderView::find_hovered_pixel(const Document& document, bool hovered) {
  const glm::ivec2 pixel =
      glm::ivec2(glm::floor(transform_.to_pixel(from_imgui(ImGui::GetMousePos()))));
  const bool inside = pixel.x >= 0 && pixel.y >= 0 && pixel.x < document.settings().width &&
                      pixel.y < document.settings().height;
  hovered_pixel_ = hovered && inside ? std::optional(pixel) : std::nullopt;
}

}  // namespace guidelight

#include "ui/render_view.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>

#include "ui/legend.h"
#include "ui/overlays/scene_overlays.h"
#include "ui/theme.h"
#include "ui/tools/region_tool.h"
#include "ui/widgets.h"

namespace guidelight {
namespace {

constexpr float kDensityOpacity = 0.9f;  // over the picture

}  // namespace

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
  ImGui::SetItemAllowOverlap();  // by the line of the wipe
  const bool hovered = ImGui::IsItemHovered();
  list.PushClipRect(to_imgui(corner), to_imgui(corner + room), true);
  if (document.technique_view().shown) {
    draw_techniques(document, list, corner, room, hovered);
    list.PopClipRect();
    return;
  }
  find_hovered_pixel(document, hovered);
  draw_picture(list);
  draw_other(list, hovered);
  draw_scene_overlays(document, toolbox, list, corner, room, hovered);
  list.PopClipRect();
}

/// The wheel and the middle button move the large picture of one.
void RenderView::draw_techniques(Document& document, ImDrawList& list, Vec2 corner, Vec2 room,
                                 bool hovered) {
  const ImGuiIO& io = ImGui::GetIO();
  if (document.technique_view().enlarged && hovered) {
    if (io.MouseWheel != 0) {
      transform_.zoom_about(from_imgui(io.MousePos), std::pow(kZoomPerStep, io.MouseWheel));
    }
    if (ImGui::IsMouseDown(ImGuiMouseButton_Middle)) transform_.move(from_imgui(io.MouseDelta));
  }
  TechniqueBrowser::Room place{corner, room, from_imgui(io.MousePos), hovered, {}};
  if (hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
    place.click = window_.press_position(ImGuiMouseButton_Left);
  }
  techniques_.draw(document, transform_, list, place);
}

void RenderView::draw_picture(ImDrawList& list) {
  if (!picture_ || texture_.empty()) return;
  const Vec2 size(picture_->snapshot->full_width, picture_->snapshot->full_height);
  const float texel = transform_.scale() * size.x / static_cast<float>(picture_->image.width);
  texture_.set_smooth(picture_->snapshot->coarse || (texel != 1 && texel < 2));
  list.AddImage(texture_.id(), to_imgui(transform_.to_screen(Vec2(0))),
                to_imgui(transform_.to_screen(size)));
}

void RenderView::draw_other(ImDrawList& list, bool hovered) {
  using Mode = Comparison::Mode;
  const bool alone = hovered && window_.modifiers() == GLFW_MOD_SHIFT && !mouse_.active();
  const bool errors = !alone && comparison_.mode == Mode::ErrorMap;
  if (!comparison_.fits() || (!alone && comparison_.mode == Mode::Off)) return;
  const auto shown = errors ? comparison_.error_displayed() : comparison_.other_displayed();
  if (!shown || !picture_) return;
  if (shown != other_) {
    other_ = shown;
    other_texture_.upload(*shown);
  }
  other_texture_.set_smooth(transform_.scale() != 1 && transform_.scale() < 2);
  const float share = !alone && !errors ? comparison_.wipe : 1.0f;
  const Vec2 size(picture_->snapshot->full_width, picture_->snapshot->full_height);
  list.AddImage(other_texture_.id(), to_imgui(transform_.to_screen(Vec2(0))),
                to_imgui(transform_.to_screen(size * Vec2(share, 1))), {0, 0}, {share, 1});
  if (alone) {
    const Vec2 top = transform_.to_screen(Vec2(size.x / 2, 0));
    draw_hint(list, top + Vec2(0, scaled(24)), comparison_.other().name);
  } else if (!errors) {
    drag_wipe(list);
  }
}

void RenderView::drag_wipe(ImDrawList& list) {
  const Vec2 size(picture_->snapshot->full_width, picture_->snapshot->full_height);
  const Vec2 top = transform_.to_screen(size * Vec2(comparison_.wipe, 0));
  const Vec2 bottom = transform_.to_screen(size * Vec2(comparison_.wipe, 1));
  const float half = scaled(5);
  ImGui::SetCursorScreenPos({top.x - half, top.y});
  ImGui::InvisibleButton("wipe", {2 * half, std::max(1.0f, bottom.y - top.y)});
  const bool lit = ImGui::IsItemHovered() || ImGui::IsItemActive();
  if (lit) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  if (ImGui::IsItemActive()) {
    const float pixel = transform_.to_pixel(from_imgui(ImGui::GetMousePos())).x;
    comparison_.wipe = std::clamp(pixel / size.x, 0.0f, 1.0f);
  }
  list.AddLine(to_imgui(top), to_imgui(bottom), lit ? palette::kAccent : palette::kText,
               scaled(lit ? 2 : 1));
}

void RenderView::draw_scene_overlays(Document& document, Toolbox& toolbox, ImDrawList& list,
                                     Vec2 corner, Vec2 room, bool hovered) {
  const auto scene = document.current_scene();
  const ViewProjection projection = project_scene(scene->camera(), transform_.to_screen(Vec2(0)),
                                                  transform_.scale(), scene->bounds());
  ToolView view{projection, &transform_};
  view.mouse = from_imgui(ImGui::GetMousePos());
  view.hovered = hovered;
  view.double_click = ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
  const RenderSettings& settings = document.settings();
  NavigationTarget target;
  target.move = [&](const auto& move) { document.move_camera(move); };
  target.find_pivot = [&] { document.find_pivot(); };
  target.picture = &transform_;
  target.room = room;
  target.picture_height = transform_.scale() * static_cast<float>(settings.height);
  mouse_.update(document, toolbox, view, target, hovered);

  draw_photons(projection, list, corner, room);
  if (settings.region) draw_region(*settings.region, settings, transform_, list);
  draw_overlays(document, display_.photons().get(), view, list);
  toolbox.tool().draw(document, view, list);
  draw_legends(list, corner + room);
  const std::string hint = toolbox.tool().hint();
  if (!hint.empty()) draw_hint(list, corner + Vec2(room.x / 2, room.y - scaled(32)), hint);
}

/// Side by side from the lower right corner.
void RenderView::draw_legends(ImDrawList& list, Vec2 corner) const {
  if (picture_ && picture_->display.curve == ToneCurve::FalseColor) {
    corner.x -= draw_legend(list, corner, *picture_);
  }
  if (comparison_.fits() && comparison_.mode == Comparison::Mode::ErrorMap) {
    corner.x -= draw_color_scale(list, corner,
                                 {Comparison::kErrorColors, Comparison::kSmallestErrorShown,
                                  Comparison::kLargestErrorShown, "relative error²"});
  }
  display_.draw_density_scale(list, corner);
}

/// Depth-tested against the scene, which itself stays invisible.
void RenderView::draw_photons(const ViewProjection& projection, ImDrawList& list, Vec2 corner,
                              Vec2 room) {
  if ((!display_.has_points() && !display_.has_density()) || !picture_) return;
  const Mat4 clip_from_world = projection.clip_from_world(corner, room);
  if (clip_from_world != photons_from_world_ || display_.version() != photons_version_) {
    photons_from_world_ = clip_from_world;
    photons_version_ = display_.version();
    photons_.begin(static_cast<int>(room.x), static_cast<int>(room.y), Vec4(0));
    MeshRaster::Look look;
    look.style = MeshStyle::DepthOnly;
    display_.draw_mesh(clip_from_world, look);
    look.style = MeshStyle::Map;
    look.opacity = kDensityOpacity;
    display_.draw_density(clip_from_world, look);
    display_.draw_photons(clip_from_world, {});
    RasterTarget::end();
  }
  const Vec2 size(picture_->snapshot->full_width, picture_->snapshot->full_height);
  list.PushClipRect(to_imgui(transform_.to_screen(Vec2(0))), to_imgui(transform_.to_screen(size)),
                    true);
  list.AddImage(photons_.id(), to_imgui(corner), to_imgui(corner + room));
  list.PopClipRect();
}

void RenderView::find_hovered_pixel(Document& document, bool hovered) const {
  const glm::ivec2 pixel =
      glm::ivec2(glm::floor(transform_.to_pixel(from_imgui(ImGui::GetMousePos()))));
  const bool inside = pixel.x >= 0 && pixel.y >= 0 && pixel.x < document.settings().width &&
                      pixel.y < document.settings().height;
  if (hovered && inside) document.view().hovered_pixel = pixel;
}

}  // namespace guidelight

#include "ui/scout/scout_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "ui/format.h"
#include "ui/overlays/scene_overlays.h"
#include "ui/theme.h"
#include "ui/widgets.h"

namespace guidelight {
namespace {

constexpr float kFieldOfView = 60;  // [degrees] of the smaller side
constexpr float kSurfaceDensityOpacity = 0.9f;
const Vec4 kScoutBackground{0.105f, 0.11f, 0.115f, 1};

}  // namespace

void ScoutView::show(const Document& document) {
  settings_.clip_axis = ScoutSettings::Axis::None;
  stand_at_render_camera(document);
}

void ScoutView::stand_at_render_camera(const Document& document) {
  const CameraController& render = document.camera();
  camera_ =
      CameraController(lens(Vec2(1)), render.pivot_distance(), document.scene().bounds().radius());
  // Without scale and shear, whatever the scene's camera has.
  Mat4 pose(1.0f);
  pose[0] = Vec4(-render.right(), 0);
  pose[1] = Vec4(render.up(), 0);
  pose[2] = Vec4(render.forward(), 0);
  pose[3] = Vec4(render.position(), 1);
  camera_.stand(pose, render.world_up(), render.pivot_distance());
}

Camera ScoutView::lens(Vec2 room) const {
  CameraDescription description;
  description.fov = kFieldOfView;
  description.fov_axis = FovAxis::Smaller;
  description.to_world = camera_.to_world();
  description.near_clip = 0;
  FilmDescription film;
  film.width = std::max(1, static_cast<int>(room.x));
  film.height = std::max(1, static_cast<int>(room.y));
  return {description, film};
}

Vec4 ScoutView::clip_plane(const Bounds& bounds) const {
  if (settings_.clip_axis == ScoutSettings::Axis::None) return {0, 0, 0, 1};
  const int axis = static_cast<int>(settings_.clip_axis) - 1;
  const float position = glm::mix(bounds.lower[axis], bounds.upper[axis], settings_.clip_share);
  Vec4 plane(0);
  plane[axis] = settings_.clip_flipped ? 1.0f : -1.0f;
  plane.w = -plane[axis] * position;
  return plane;
}

void ScoutView::draw(Document& document, Toolbox& toolbox) {
  hovered_ = false;
  if (!document.has_scene()) return;
  const Vec2 corner = from_imgui(ImGui::GetCursorScreenPos());
  const Vec2 room = glm::max(from_imgui(ImGui::GetContentRegionAvail()), Vec2(1));
  ImGui::SetItemAllowOverlap();
  ImGui::InvisibleButton("scout", to_imgui(room),
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                             ImGuiButtonFlags_MouseButtonMiddle);
  ImGui::SetItemAllowOverlap();
  hovered_ = ImGui::IsItemHovered();

  const auto scene = document.current_scene();
  const Bounds bounds = scene->bounds();
  const auto project = [&] { return project_scene(lens(room), corner, 1, bounds); };
  const ViewProjection before = project();
  ToolView view{before, nullptr, clip_plane(bounds), settings_.style != MeshStyle::Shaded};
  view.mouse = from_imgui(ImGui::GetMousePos());
  view.hovered = hovered_;
  view.double_click = ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
  NavigationTarget target;
  target.move = [&](const auto& move) { camera_.move(move); };
  target.find_pivot = [&] {
    const auto distance = pivot_distance(*scene->with_camera(lens(room)));
    if (distance) camera_.set_pivot_distance(*distance);
  };
  target.room = room;
  target.picture_height = room.y;
  mouse_.update(document, toolbox, view, target, hovered_);

  const ViewProjection projection = project();
  ToolView now{projection, nullptr, view.clip_plane, view.sees_through, view.mouse};
  now.hovered = hovered_;
  rasterise(projection, view.clip_plane, corner, room);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect(to_imgui(corner), to_imgui(corner + room), true);
  list.AddImage(target_.id(), to_imgui(corner), to_imgui(corner + room));
  draw_lights(*scene, now, list);
  draw_render_camera(*scene, now, list);
  draw_overlays(document, display_.photons().get(), now, list);
  display_.draw_density_scale(list, corner + room);
  toolbox.tool().draw(document, now, list);
  const std::string hint = toolbox.tool().hint();
  if (!hint.empty()) draw_hint(list, corner + Vec2(room.x / 2, room.y - scaled(32)), hint);
  list.PopClipRect();
  draw_toolbar(document, corner, room);
}

void ScoutView::rasterise(const ViewProjection& projection, Vec4 clip, Vec2 corner, Vec2 room) {
  const Drawn wanted{projection.clip_from_world(corner, room), room, settings_, display_.version()};
  if (wanted == drawn_) return;
  drawn_ = wanted;
  target_.begin(static_cast<int>(room.x), static_cast<int>(room.y), kScoutBackground);
  display_.draw_mesh(wanted.clip_from_world, {settings_.style, camera_.position(), clip});
  display_.draw_density(wanted.clip_from_world,
                        {MeshStyle::Map, camera_.position(), clip, kSurfaceDensityOpacity});
  PointRaster::Look look;
  look.clip_plane = clip;
  display_.draw_photons(wanted.clip_from_world, look);
  RasterTarget::end();
}

// -- The controls in the view's upper edge.

void ScoutView::draw_toolbar(const Document& document, Vec2 corner, Vec2 room) {
  static constexpr std::array kStyles = {
      std::pair{"Shaded", "Surfaces, lit from the camera"},
      std::pair{"Wire", "The edges of triangles"},
      std::pair{"See-through", "All surfaces at once, their rims brightest"}};
  ImGui::SetCursorScreenPos(to_imgui(corner + scaled(8)));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {scaled(4), scaled(4)});
  ImGui::BeginGroup();
  for (int i = 0; i < static_cast<int>(kStyles.size()); ++i) {
    if (i > 0) ImGui::SameLine();
    if (toggle_button(kStyles[i].first, settings_.style == static_cast<MeshStyle>(i))) {
      settings_.style = static_cast<MeshStyle>(i);
    }
    tooltip(kStyles[i].second);
  }
  if (room.x > scaled(460)) ImGui::SameLine(0, scaled(14));
  draw_clip_controls(document);
  ImGui::EndGroup();
  ImGui::PopStyleVar();
}

void ScoutView::draw_clip_controls(const Document& document) {
  static constexpr std::array kAxes = {"No clip plane", "Clip across X", "Clip across Y",
                                       "Clip across Z"};
  int axis = static_cast<int>(settings_.clip_axis);
  ImGui::SetNextItemWidth(scaled(124));
  if (ImGui::Combo("##clip axis", &axis, kAxes.data(), kAxes.size())) {
    settings_.clip_axis = static_cast<ScoutSettings::Axis>(axis);
  }
  tooltip("Cuts a part of the scene away, a ceiling for instance");
  if (axis == 0) return;
  const Bounds bounds = document.scene().bounds();
  const float position =
      glm::mix(bounds.lower[axis - 1], bounds.upper[axis - 1], settings_.clip_share);
  ImGui::SameLine();
  ImGui::SetNextItemWidth(scaled(110));
  ImGui::SliderFloat("##clip position", &settings_.clip_share, 0, 1,
                     format_value(position).c_str());
  tooltip("Where the plane is along the axis [scene units]");
  ImGui::SameLine();
  if (toggle_button("Flip", settings_.clip_flipped)) {
    settings_.clip_flipped = !settings_.clip_flipped;
  }
  tooltip("Cuts the other side away");
}

}  // namespace guidelight

#include "ui/render_view.h"

#include <algorithm>

#include "ui/legend.h"
#include "ui/theme.h"
#include "ui/tools/inspect_tool.h"
#include "ui/tools/region_tool.h"
#include "ui/widgets.h"

namespace guidelight {
namespace {

constexpr float kOrbitPerHeight = kPi;  // [rad] for a drag over the height of the view
constexpr float kLookPerHeight = 1.2f;  // [rad]
constexpr float kZoomPerStep = 1.25f;
constexpr float kSpeedPerStep = 1.3f;
constexpr float kLongestStep = 0.05f;  // [s] of flight per frame, if frames take longer

struct Button {
  MouseInput input;
  ImGuiMouseButton number;
};
constexpr Button kButtons[] = {{MouseInput::Left, ImGuiMouseButton_Left},
                               {MouseInput::Right, ImGuiMouseButton_Right},
                               {MouseInput::Middle, ImGuiMouseButton_Middle}};

void centered_text(ImDrawList& list, Vec2 center, ImU32 color, const char* text) {
  const Vec2 size = from_imgui(ImGui::CalcTextSize(text));
  list.AddText(to_imgui(glm::round(center - 0.5f * size)), color, text);
}

/// Text on a dark pill, centred.
void draw_hint(ImDrawList& list, Vec2 center, const char* text) {
  const Vec2 half = 0.5f * from_imgui(ImGui::CalcTextSize(text)) + Vec2(scaled(12), scaled(6));
  list.AddRectFilled(to_imgui(center - half), to_imgui(center + half), IM_COL32(20, 20, 20, 215),
                     half.y);
  centered_text(list, center, palette::kText, text);
}

}  // namespace

RenderView::RenderView(const Window& window)
    : window_(window), tool_(std::make_unique<InspectTool>()) {}

void RenderView::show(std::shared_ptr<const Picture> picture) {
  picture_ = std::move(picture);
  if (picture_) texture_.upload(picture_->image);
}

void RenderView::use_region_tool() { tool_ = std::make_unique<RegionTool>(); }
void RenderView::use_default_tool() { tool_ = std::make_unique<InspectTool>(); }
bool RenderView::region_tool_active() const {
  return dynamic_cast<const RegionTool*>(tool_.get()) != nullptr;
}

void RenderView::draw(Document& document) {
  const Vec2 corner = from_imgui(ImGui::GetCursorScreenPos());
  const Vec2 room = glm::max(from_imgui(ImGui::GetContentRegionAvail()), Vec2(1));
  if (document.has_scene()) {
    transform_.set_room(corner, room, Vec2(document.settings().width, document.settings().height));
  }
  ImGui::InvisibleButton("picture", to_imgui(room),
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                             ImGuiButtonFlags_MouseButtonMiddle);
  handle_mouse(document, ImGui::IsItemHovered(), room);

  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect(to_imgui(corner), to_imgui(corner + room), true);
  draw_picture(list);
  draw_overlays(document, list, corner, room);
  list.PopClipRect();
}

// -- Drawing.

void RenderView::draw_picture(ImDrawList& list) {
  if (!picture_ || texture_.empty()) return;
  const Vec2 size(picture_->snapshot->full_width, picture_->snapshot->full_height);
  const float texel = transform_.scale() * size.x / static_cast<float>(picture_->image.width);
  texture_.set_smooth(picture_->snapshot->coarse || (texel != 1 && texel < 2));
  list.AddImage(texture_.id(), to_imgui(transform_.to_screen(Vec2(0))),
                to_imgui(transform_.to_screen(size)));
}

void RenderView::draw_overlays(const Document& document, ImDrawList& list, Vec2 corner, Vec2 room) {
  if (!document.has_scene()) {
    const std::string invitation =
        "Drop a scene here, or press " + shortcut_text(Action::OpenScene);
    centered_text(list, corner + 0.5f * room, palette::kDim, invitation.c_str());
    return;
  }
  const RenderSettings& settings = document.settings();
  if (settings.region) draw_region(*settings.region, settings, transform_, list);
  tool_->draw(document, transform_, list);
  if (picture_ && picture_->display.curve == ToneCurve::FalseColor) {
    draw_legend(list, corner + room, *picture_);
  }
  if (*tool_->hint()) {
    draw_hint(list, corner + Vec2(room.x / 2, room.y - scaled(32)), tool_->hint());
  }
}

// -- The mouse.

void RenderView::handle_mouse(Document& document, bool hovered, Vec2 room) {
  hovered_pixel_.reset();
  if (!document.has_scene()) return;
  const glm::ivec2 pixel =
      glm::ivec2(glm::floor(transform_.to_pixel(from_imgui(ImGui::GetMousePos()))));
  const bool inside = pixel.x >= 0 && pixel.y >= 0 && pixel.x < document.settings().width &&
                      pixel.y < document.settings().height;
  if (hovered && inside) hovered_pixel_ = pixel;

  if (!gesture_ && hovered) begin_gesture(document);
  if (gesture_) continue_gesture(document, room);
  if (gesture_ && !ImGui::IsMouseDown(gesture_button_)) end_gesture(document);
  if (hovered && ImGui::GetIO().MouseWheel != 0) turn_wheel(document);
}

void RenderView::begin_gesture(Document& document) {
  for (const Button& button : kButtons) {
    if (!ImGui::IsMouseClicked(button.number)) continue;
    gesture_ = gesture_for(button.input, window_.modifiers());
    gesture_button_ = button.number;
    if (gesture_ == Gesture::UseTool) {
      tool_->press(document, transform_.to_pixel(from_imgui(ImGui::GetMousePos())));
    }
    return;
  }
}

void RenderView::continue_gesture(Document& document, Vec2 room) {
  const Vec2 moved = from_imgui(ImGui::GetIO().MouseDelta);
  const bool still = moved == Vec2(0);
  switch (*gesture_) {
    case Gesture::UseTool:
      if (!still) tool_->drag(document, transform_.to_pixel(from_imgui(ImGui::GetMousePos())));
      break;
    case Gesture::Orbit:
      if (!still) {
        document.move_camera(
            [&](CameraController& camera) { camera.orbit(moved * (kOrbitPerHeight / room.y)); });
      }
      break;
    case Gesture::Pan:
      if (!still) {
        const float height = transform_.scale() * static_cast<float>(document.settings().height);
        document.move_camera([&](CameraController& camera) { camera.pan(moved / height); });
      }
      break;
    case Gesture::Fly:
      fly(document, moved * (kLookPerHeight / room.y));
      break;
    case Gesture::PanImage:
      transform_.move(moved);
      break;
    case Gesture::Dolly:
    case Gesture::ZoomImage:
      break;  // the wheel's
  }
}

void RenderView::end_gesture(Document& document) {
  if (gesture_ == Gesture::UseTool) {
    tool_->release(document, transform_.to_pixel(from_imgui(ImGui::GetMousePos())));
    if (tool_->finished()) use_default_tool();
  }
  if (gesture_ == Gesture::Fly) document.find_pivot();
  gesture_.reset();
}

void RenderView::turn_wheel(Document& document) {
  const float steps = ImGui::GetIO().MouseWheel;
  if (gesture_ == Gesture::Fly) {
    fly_speed_ *= std::pow(kSpeedPerStep, steps);
    return;
  }
  const auto gesture = gesture_for(MouseInput::Wheel, window_.modifiers());
  if (gesture == Gesture::Dolly) {
    document.move_camera([&](CameraController& camera) { camera.dolly(steps); });
  } else if (gesture == Gesture::ZoomImage) {
    transform_.zoom_about(from_imgui(ImGui::GetMousePos()), std::pow(kZoomPerStep, steps));
  }
}

void RenderView::fly(Document& document, Vec2 angles) {
  Vec3 direction{0};
  for (const FlyKey& key : fly_keys()) {
    if (window_.key_down(key.key)) direction += key.direction;
  }
  if (direction == Vec3(0) && angles == Vec2(0)) return;
  const float seconds = std::min(ImGui::GetIO().DeltaTime, kLongestStep);
  const float radius = document.scene().bounds().radius();
  const float step = fly_speed_ * radius * fly_speed_factor(window_.modifiers()) * seconds;
  document.move_camera([&](CameraController& camera) {
    camera.look(angles);
    camera.fly(direction * step);
  });
}

}  // namespace guidelight

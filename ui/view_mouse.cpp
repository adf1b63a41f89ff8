#include "ui/view_mouse.h"

#include <algorithm>

#include "ui/widgets.h"

namespace guidelight {
namespace {

constexpr float kOrbitPerHeight = kPi;  // [rad] for a drag over the height of the view
constexpr float kLookPerHeight = 1.2f;  // [rad]
constexpr float kSpeedPerStep = 1.3f;
constexpr float kSlowest = 1e-4f;  // flight [radii of the scene per second]
constexpr float kFastest = 1e2f;
constexpr float kLongestStep = 0.05f;  // [s] of flight per frame, if frames take longer

struct Button {
  MouseInput input;
  ImGuiMouseButton number;
};
constexpr Button kButtons[] = {{MouseInput::Left, ImGuiMouseButton_Left},
                               {MouseInput::Right, ImGuiMouseButton_Right},
                               {MouseInput::Middle, ImGuiMouseButton_Middle}};

}  // namespace

void ViewMouse::update(Document& document, Toolbox& toolbox, const ToolView& view,
                       const NavigationTarget& target, bool hovered) {
  if (!gesture_ && hovered) {
    begin(document, toolbox, view);
  } else if (gesture_ && ImGui::IsMouseDown(button_)) {
    go_on(document, toolbox, view, target);
  }
  if (gesture_) {
    // What is under the mouse is the gesture's.
  } else if (hovered) {
    toolbox.tool().hover(document, view);
  } else if (was_hovered_) {
    toolbox.tool().leave();
  }
  was_hovered_ = hovered;
  if (gesture_ && !ImGui::IsMouseDown(button_)) end(document, toolbox, view, target);
  if (hovered && ImGui::GetIO().MouseWheel != 0) turn_wheel(target);
}

void ViewMouse::begin(Document& document, Toolbox& toolbox, const ToolView& view) {
  for (const Button& button : kButtons) {
    if (!ImGui::IsMouseClicked(button.number)) continue;
    gesture_ = gesture_for(button.input, window_.modifiers());
    button_ = button.number;
    last_mouse_ = window_.press_position(button_);
    if (gesture_ == Gesture::UseTool) {
      ToolView at_press = view;
      at_press.mouse = last_mouse_;
      toolbox.tool().press(document, at_press);
    }
    return;
  }
}

void ViewMouse::go_on(Document& document, Toolbox& toolbox, const ToolView& view,
                      const NavigationTarget& target) {
  const Vec2 moved = view.mouse - last_mouse_;
  last_mouse_ = view.mouse;
  if (gesture_ == Gesture::Fly) {
    const Bounds bounds = document.scene().bounds();
    fly(target, bounds.empty() ? 1 : bounds.radius(), moved * (kLookPerHeight / target.room.y));
    return;
  }
  if (moved == Vec2(0)) return;
  switch (*gesture_) {
    case Gesture::UseTool:
      toolbox.tool().drag(document, view);
      break;
    case Gesture::Orbit:
      target.move([&](CameraController& camera) {
        camera.orbit(moved * (kOrbitPerHeight / target.room.y));
      });
      break;
    case Gesture::Pan:
      target.move([&](CameraController& camera) { camera.pan(moved / target.picture_height); });
      break;
    case Gesture::PanImage:
      if (target.picture) target.picture->move(moved);
      break;
    case Gesture::Fly:
    case Gesture::Dolly:
    case Gesture::ZoomImage:
      break;  // above, and the wheel's
  }
}

void ViewMouse::end(Document& document, Toolbox& toolbox, const ToolView& view,
                    const NavigationTarget& target) {
  ToolView at_release = view;
  at_release.mouse = window_.release_position(button_);
  go_on(document, toolbox, at_release, target);
  if (gesture_ == Gesture::UseTool) {
    toolbox.tool().release(document, at_release);
    toolbox.tidy();
  }
  if (gesture_ == Gesture::Fly) target.find_pivot();
  gesture_.reset();
}

void ViewMouse::turn_wheel(const NavigationTarget& target) {
  const float steps = ImGui::GetIO().MouseWheel;
  if (flying()) {
    fly_speed_ = std::clamp(fly_speed_ * std::pow(kSpeedPerStep, steps), kSlowest, kFastest);
    return;
  }
  const auto gesture = gesture_for(MouseInput::Wheel, window_.modifiers());
  if (gesture == Gesture::Dolly) {
    target.move([&](CameraController& camera) { camera.dolly(steps); });
  } else if (gesture == Gesture::ZoomImage && target.picture) {
    target.picture->zoom_about(from_imgui(ImGui::GetMousePos()), std::pow(kZoomPerStep, steps));
  }
}

void ViewMouse::fly(const NavigationTarget& target, float scene_radius, Vec2 angles) const {
  Vec3 direction{0};
  for (const FlyKey& key : fly_keys()) {
    if (window_.key_down(key.key)) direction += key.direction;
  }
  if (direction == Vec3(0) && angles == Vec2(0)) return;
  const float seconds = std::min(ImGui::GetIO().DeltaTime, kLongestStep);
  const float speed = fly_speed_ * scene_radius * fly_speed_factor(window_.modifiers());
  target.move([&](CameraController& camera) {
    camera.look(angles);
    camera.fly(direction * (speed * seconds));
  });
}

}  // namespace guidelight

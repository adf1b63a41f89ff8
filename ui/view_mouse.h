#pragma once

#include <functional>
#include <optional>

#include "ui/camera_controller.h"
#include "ui/tools/toolbox.h"
#include "ui/window.h"

namespace guidelight {

inline constexpr float kZoomPerStep = 1.25f;  // of the wheel

/// What the mouse moves in a view.
struct NavigationTarget {
  std::function<void(const std::function<void(CameraController&)>&)> move;
  std::function<void()> find_pivot;  // after the camera has turned by itself
  ViewTransform* picture = nullptr;  // zoomed and moved by the wheel; may be null
  Vec2 room{1};                      // of the view [pixels]
  float picture_height = 1;          // what the camera's height is on the screen [pixels]
};

/// What the mouse does in a view: tools with the left button, the camera with the others, the same
/// way in every view.
class ViewMouse {
 public:
  explicit ViewMouse(const Window& window) : window_(window) {}

  /// To be called once per frame; `hovered`: the mouse is over the view and nothing covers it.
  void update(Document& document, Toolbox& toolbox, const ToolView& view,
              const NavigationTarget& target, bool hovered);
  bool active() const { return gesture_.has_value(); }
  bool flying() const { return gesture_ == Gesture::Fly; }

 private:
  void begin(Document& document, Toolbox& toolbox, const ToolView& view);
  void go_on(Document& document, Toolbox& toolbox, const ToolView& view,
             const NavigationTarget& target);
  void end(Document& document, Toolbox& toolbox, const ToolView& view,
           const NavigationTarget& target);
  void turn_wheel(const NavigationTarget& target);
  void fly(const NavigationTarget& target, float scene_radius, Vec2 angles) const;

  const Window& window_;
  std::optional<Gesture> gesture_;
  int button_ = 0;          // ImGui's number
  Vec2 last_mouse_{0};      // that the tool was told of [pixels]
  float fly_speed_ = 0.4f;  // [radii of the scene per second]
  bool was_hovered_ = false;
};

}  // namespace guidelight

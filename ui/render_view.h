#pragma once

#include <memory>
#include <optional>

#include "ui/document.h"
#include "ui/key_table.h"
#include "ui/picture_developer.h"
#include "ui/picture_texture.h"
#include "ui/tools/tool.h"
#include "ui/view_transform.h"
#include "ui/window.h"

namespace guidelight {

/// The picture, what is drawn over it, and what the mouse does there.
class RenderView {
 public:
  explicit RenderView(const Window& window);

  void show(std::shared_ptr<const Picture> picture);
  /// What is on the screen; null before the first.
  const std::shared_ptr<const Picture>& picture() const { return picture_; }

  /// Fills the current ImGui window.
  void draw(Document& document);

  ViewTransform& transform() { return transform_; }
  const ViewTransform& transform() const { return transform_; }
  /// Under the mouse; empty outside the picture.
  std::optional<glm::ivec2> hovered_pixel() const { return hovered_pixel_; }

  void use_region_tool();
  void use_default_tool();
  bool region_tool_active() const;

  /// Whether the view must be drawn again at once, because something moves by itself.
  bool animating() const { return gesture_ == Gesture::Fly; }

 private:
  void draw_picture(ImDrawList& list);
  void draw_overlays(const Document& document, ImDrawList& list, Vec2 corner, Vec2 room);
  void handle_mouse(Document& document, bool hovered, Vec2 room);
  void begin_gesture(Document& document);
  void continue_gesture(Document& document, Vec2 room);
  void end_gesture(Document& document);
  void turn_wheel(Document& document);
  void fly(Document& document, Vec2 angles);

  const Window& window_;
  std::shared_ptr<const Picture> picture_;
  PictureTexture texture_;
  ViewTransform transform_;
  std::unique_ptr<Tool> tool_;
  std::optional<Gesture> gesture_;
  int gesture_button_ = 0;  // ImGui's number
  float fly_speed_ = 0.4f;  // [radii of the scene per second]
  std::optional<glm::ivec2> hovered_pixel_;
};

}  // namespace guidelight

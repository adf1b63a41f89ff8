#pragma once

#include <memory>
#include <optional>

#include "ui/document.h"
#include "ui/picture_developer.h"
#include "ui/picture_texture.h"
#include "ui/view_mouse.h"
#include "ui/view_transform.h"
#include "ui/window.h"

namespace guidelight {

/// The picture and what is drawn over it.
class RenderView {
 public:
  explicit RenderView(const Window& window) : mouse_(window) {}

  void show(std::shared_ptr<const Picture> picture);
  /// What is on the screen; null before the first.
  const std::shared_ptr<const Picture>& picture() const { return picture_; }

  /// Fills the current ImGui window.
  void draw(Document& document, Toolbox& toolbox);

  ViewTransform& transform() { return transform_; }
  const ViewTransform& transform() const { return transform_; }
  /// Under the mouse; empty outside the picture.
  std::optional<glm::ivec2> hovered_pixel() const { return hovered_pixel_; }

  /// Whether the view must be drawn again at once, because something moves by itself.
  bool animating() const { return mouse_.flying(); }

 private:
  void draw_picture(ImDrawList& list);
  void draw_scene_overlays(Document& document, Toolbox& toolbox, ImDrawList& list, Vec2 corner,
                           Vec2 room, bool hovered);
  void find_hovered_pixel(const Document& document, bool hovered);

  std::shared_ptr<const Picture> picture_;
  PictureTexture texture_;
  ViewTransform transform_;
  ViewMouse mouse_;
  std::optional<glm::ivec2> hovered_pixel_;
};

}  // namespace guidelight

#pragma once

#include <imgui.h>

#include "ui/picture_texture.h"
#include "ui/techniques/pyramid_layout.h"
#include "ui/techniques/technique_gallery.h"
#include "ui/view_transform.h"

namespace guidelight {

/// Shows all techniques as a pyramid, or one of them large, in place of the picture. A click
/// enlarges one, the next goes back.
class TechniqueBrowser {
 public:
  explicit TechniqueBrowser(const TechniqueGallery& gallery) : gallery_(gallery) {}

  /// The part of the screen that it fills, and the mouse there.
  struct Room {
    Vec2 corner;
    Vec2 size;
    Vec2 mouse;
    bool hovered;
    std::optional<Vec2> click;  // of the left button, in this frame
  };
  void draw(Document& document, const ViewTransform& transform, ImDrawList& list, const Room& room);

 private:
  void take_pictures();
  void draw_pyramid(TechniqueView& view, float aspect, ImDrawList& list, const Room& room) const;
  void draw_thumbnail(size_t index, Vec2 corner, Vec2 other, ImDrawList& list) const;
  void draw_large(const TechniqueView& view, Vec2 picture_size, const ViewTransform& transform,
                  ImDrawList& list, const Room& room);
  std::string caption(size_t index, bool weighted) const;

  const TechniqueGallery& gallery_;
  std::shared_ptr<const TechniquePictures> pictures_;  // in the textures
  PictureTexture stack_;
  PictureTexture large_;
};

}  // namespace guidelight

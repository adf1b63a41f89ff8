#pragma once

#include <memory>
#include <optional>

#include "ui/compare/comparison.h"
#include "ui/display_scene.h"
#include "ui/document.h"
#include "ui/gl/raster_target.h"
#include "ui/picture_developer.h"
#include "ui/picture_texture.h"
#include "ui/techniques/technique_browser.h"
#include "ui/view_mouse.h"
#include "ui/view_transform.h"
#include "ui/window.h"

namespace guidelight {

/// The picture and what is drawn over it.
class RenderView {
 public:
  RenderView(const Window& window, const DisplayScene& display, Comparison& comparison,
             const TechniqueGallery& techniques)
      : window_(window),
        display_(display),
        comparison_(comparison),
        techniques_(techniques),
        mouse_(window) {}

  void show(std::shared_ptr<const Picture> picture);
  /// What is on the screen; null before the first.
  const std::shared_ptr<const Picture>& picture() const { return picture_; }

  /// Fills the current ImGui window.
  void draw(Document& document, Toolbox& toolbox);

  ViewTransform& transform() { return transform_; }
  const ViewTransform& transform() const { return transform_; }
  /// Whether the view must be drawn again at once, because something moves by itself.
  bool animating() const { return mouse_.flying(); }

 private:
  void draw_techniques(Document& document, ImDrawList& list, Vec2 corner, Vec2 room, bool hovered);
  void draw_picture(ImDrawList& list);
  /// The picture that is compared with, over a part of the picture or all of it.
  void draw_other(ImDrawList& list, bool hovered);
  void drag_wipe(ImDrawList& list);
  void draw_scene_overlays(Document& document, Toolbox& toolbox, ImDrawList& list, Vec2 corner,
                           Vec2 room, bool hovered);
  void draw_photons(const ViewProjection& projection, ImDrawList& list, Vec2 corner, Vec2 room);
  void draw_legends(ImDrawList& list, Vec2 corner) const;
  void find_hovered_pixel(Document& document, bool hovered) const;

  const Window& window_;
  const DisplayScene& display_;
  Comparison& comparison_;
  TechniqueBrowser techniques_;
  std::shared_ptr<const Picture> picture_;
  PictureTexture texture_;
  ViewTransform transform_;
  ViewMouse mouse_;

  PictureTexture other_texture_;
  std::shared_ptr<const DisplayImage> other_;  // in the texture
  RasterTarget photons_;                       // over the picture
  Mat4 photons_from_world_{0.0f};
  uint64_t photons_version_ = 0;
};

}  // namespace guidelight

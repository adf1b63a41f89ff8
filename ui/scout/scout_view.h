#pragma once

#include <memory>
#include <optional>

#include "ui/display_scene.h"
#include "ui/gl/raster_target.h"
#include "ui/view_mouse.h"

namespace guidelight {

/// How the scout view shows the scene.
struct ScoutSettings {
  enum class Axis { None, X, Y, Z };

  MeshStyle style = MeshStyle::Shaded;
  Axis clip_axis = Axis::None;
  float clip_share = 0.8f;    // of the scene's extent along the axis
  bool clip_flipped = false;  // shows what lies above the plane instead of below

  bool operator==(const ScoutSettings&) const = default;
};

/// The scene through a camera of its own, drawn by OpenGL at once: for places that the render
/// camera does not see.
class ScoutView {
 public:
  ScoutView(const Window& window, const DisplayScene& display)
      : display_(display), mouse_(window) {}

  /// Stands where the camera of another scene is.
  void show(const Document& document);
  /// Fills the current ImGui window.
  void draw(Document& document, Toolbox& toolbox);

  void stand_at_render_camera(const Document& document);
  void frame(const Bounds& bounds) { camera_.frame(bounds); }
  CameraController& camera() { return camera_; }
  const CameraController& camera() const { return camera_; }
  ScoutSettings& settings() { return settings_; }

  bool hovered() const { return hovered_; }
  bool animating() const { return mouse_.flying(); }

 private:
  Camera lens(Vec2 room) const;
  Vec4 clip_plane(const Bounds& bounds) const;
  void rasterise(const ViewProjection& projection, Vec4 clip, Vec2 corner, Vec2 room);
  void draw_toolbar(const Document& document, Vec2 corner, Vec2 room);
  void draw_clip_controls(const Document& document);

  struct Drawn {  // what the picture was made of
    Mat4 clip_from_world{0.0f};
    Vec2 room{0};
    ScoutSettings settings;
    uint64_t version = 0;
    bool operator==(const Drawn&) const = default;
  };

  const DisplayScene& display_;
  ViewMouse mouse_;
  CameraController camera_;
  ScoutSettings settings_;
  RasterTarget target_;
  Drawn drawn_;
  bool hovered_ = false;
};

}  // namespace guidelight

#pragma once

#include <memory>
#include <optional>

#include "ui/background_thread.h"
#include "ui/document.h"
#include "ui/gl/mesh_raster.h"
#include "ui/gl/raster_target.h"
#include "ui/ui_queue.h"
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
  ScoutView(const Window& window, UiQueue& queue);
  ~ScoutView();

  /// Prepares another scene and stands where its camera is.
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
    uint64_t mesh = 0;
    bool operator==(const Drawn&) const = default;
  };

  UiQueue& queue_;
  ViewMouse mouse_;
  CameraController camera_;
  ScoutSettings settings_;
  std::unique_ptr<MeshRaster> mesh_raster_;
  RasterTarget target_;
  std::shared_ptr<const SceneDescription> shown_;
  uint64_t mesh_number_ = 0;  // of the mesh in mesh_raster_
  Drawn drawn_;
  bool hovered_ = false;
  BackgroundThread tessellator_;  // last: it finishes before the rest goes
};

}  // namespace guidelight

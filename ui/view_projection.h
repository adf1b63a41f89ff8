#pragma once

#include <optional>
#include <utility>

#include "renderer/scene/camera.h"
#include "renderer/scene/shape.h"

namespace guidelight {

/// How a view shows the world: from points to the screen, from the screen to rays, and the matrix
/// that makes OpenGL agree. Thin lenses are looked through in their middle.
class ViewProjection {
 public:
  /// The camera's raster position p is at origin + scale·p of the screen [pixels]. Nothing nearer
  /// than `near` is shown, farther than `far` OpenGL shows nothing [scene units].
  ViewProjection(const Camera& camera, Vec2 origin, float scale, float near, float far);

  /// Empty for what is behind the eye.
  std::optional<Vec2> to_screen(Vec3 point) const;
  /// The ends on the screen of the part of a line that lies before the eye, with the shares of the
  /// line where that part begins and ends.
  struct Line {
    Vec2 a;
    Vec2 b;
    float from;
    float to;
  };
  std::optional<Line> to_screen(Vec3 a, Vec3 b) const;
  /// Through a position of the screen; unit direction.
  Ray ray_through(Vec2 screen) const;
  /// From where a point is seen: the eye, or for parallel rays a place far before it.
  Vec3 seen_from(Vec3 point) const;
  /// Pixels on the screen of a unit length across the view, at a point; 0 behind the eye.
  float pixels_per_unit(Vec3 point) const;

  /// To OpenGL's clip space, for a texture whose first row is the upper one and that covers a
  /// rectangle of the screen.
  Mat4 clip_from_world(Vec2 corner, Vec2 size) const;

 private:
  float depth(Vec3 point) const { return glm::dot(forward_, point - eye_); }
  float weight(Vec3 point) const { return parallel_ ? 1.0f : depth(point); }
  Vec2 weighted_screen(Vec3 point) const;

  Vec3 eye_;
  Vec3 forward_;
  bool parallel_;
  // A point q relative to the eye is seen at screen·w = offset·w + (q·across, q·down), with the
  // weight w = 1 for parallel rays and the depth of q otherwise.
  Vec3 across_;
  Vec3 down_;
  Vec2 offset_;
  float near_;
  float far_;
};

/// The view of a whole scene: far enough for all of it, near enough for a small part.
ViewProjection project_scene(const Camera& camera, Vec2 origin, float scale, const Bounds& bounds);

}  // namespace guidelight

#pragma once

#include <functional>
#include <optional>

#include "renderer/scene/scene.h"

namespace guidelight {

/// Moves a camera the way hands expect. Every motion is a rigid transform applied in world space
/// (or a scale of an orthographic view), so mirrored and rolled cameras stay as they are. Positive
/// x of screen movements points right and positive y down, as the mouse reports them.
class CameraController {
 public:
  CameraController() = default;
  /// Takes over a camera; pivot_distance is the distance to what it orbits around [scene units].
  /// The radius of the scene limits how near and how far it dollies; 1 stands in for none.
  CameraController(const Camera& camera, float pivot_distance, float scene_radius = 1);

  const Mat4& to_world() const { return to_world_; }
  void set_to_world(const Mat4& to_world) { to_world_ = to_world; }
  /// Stands elsewhere, with the same lens.
  void stand(const Mat4& to_world, Vec3 world_up, float pivot_distance);
  Vec3 position() const { return Vec3(to_world_[3]); }
  Vec3 forward() const;
  Vec3 right() const;
  Vec3 up() const;
  /// The axis of the world closest to the camera's up when it was taken over.
  Vec3 world_up() const { return world_up_; }

  float pivot_distance() const { return pivot_distance_; }
  Vec3 pivot() const { return position() + pivot_distance_ * forward(); }
  void set_pivot_distance(float distance);

  /// Does what the motions below do, but for one that leads where no camera can be: farther than
  /// 10⁸ from the origin, or out of the range of floats.
  void move(const std::function<void(CameraController&)>& motion);
  /// Turns the world around the pivot by these angles [rad]; never past the poles.
  void orbit(Vec2 angles);
  /// Turns the view around the camera [rad]; never past the poles.
  void look(Vec2 angles);
  /// Moves what is seen at the pivot's distance by a share of the picture's height.
  void pan(Vec2 share);
  /// Nears the pivot by a tenth of the distance per step, or enlarges an orthographic view as much.
  void dolly(float steps);
  /// Moves along camera space x right, y up, z forward [scene units].
  void fly(Vec3 offset);
  /// Moves back or forth until the bounds fill the picture, without turning; empty bounds do
  /// nothing.
  void frame(const Bounds& bounds);

 private:
  void turn(Vec2 angles, Vec3 center);
  float zoomed(float size, float factor) const;
  float handedness() const;
  float view_height() const;

  Mat4 to_world_{1.0f};
  Vec3 world_up_{0, 1, 0};
  float pivot_distance_ = 1;
  float scene_radius_ = 1;
  float tan_half_height_ = 0.5f;  // perspective: tangent of half the vertical field of view
  float tan_half_width_ = 0.5f;
  bool orthographic_ = false;
};

/// The distance along the view direction to what is seen in the middle of the scene's picture;
/// empty if nothing is.
std::optional<float> pivot_distance(const Scene& scene);

}  // namespace guidelight

#include "ui/camera_controller.h"

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>

#include "renderer/math/axes.h"

namespace guidelight {
namespace {

constexpr float kPoleMargin = 2 * kPi / 180;  // how near the view may come to straight up or down
constexpr float kDollyFactor = 0.9f;
constexpr float kNearest = 1e-6f;  // that one dollies to the pivot [radii of the scene] …
constexpr float kFarthest = 1e4f;  // … and from it
constexpr float kEndOfTheWorld = 1e8f;

Vec3 closest_axis(Vec3 v) {
  const Vec3 size = glm::abs(v);
  Vec3 axis{0};
  const int i = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
  axis[i] = std::copysign(1.0f, v[i]);
  return axis;
}

Mat4 rotation_around(Vec3 center, float angle, Vec3 axis) {
  const Mat4 turned = glm::rotate(glm::translate(Mat4(1), center), angle, axis);
  return glm::translate(turned, -center);
}

}  // namespace

CameraController::CameraController(const Camera& camera, float pivot_distance, float scene_radius)
    : to_world_(camera.description().to_world),
      tan_half_height_(0.5f * camera.pixel_size_at_unit_distance() * camera.height()),
      tan_half_width_(0.5f * camera.pixel_size_at_unit_distance() * camera.width()),
      orthographic_(camera.description().model == CameraModel::Orthographic) {
  if (orthographic_) {  // of a camera of the same lens without scale
    const float scale = glm::length(Vec3(to_world_[0]));
    tan_half_height_ /= scale;
    tan_half_width_ /= scale;
  }
  world_up_ = closest_axis(up());
  set_pivot_distance(pivot_distance);
  if (std::isfinite(scene_radius) && scene_radius > 0) scene_radius_ = scene_radius;
}

Vec3 CameraController::forward() const { return glm::normalize(Vec3(to_world_[2])); }
Vec3 CameraController::right() const { return -glm::normalize(Vec3(to_world_[0])); }
Vec3 CameraController::up() const { return glm::normalize(Vec3(to_world_[1])); }

void CameraController::stand(const Mat4& to_world, Vec3 world_up, float pivot_distance) {
  to_world_ = to_world;
  world_up_ = world_up;
  set_pivot_distance(pivot_distance);
}

void CameraController::set_pivot_distance(float distance) {
  if (std::isfinite(distance) && distance > 0) pivot_distance_ = distance;
}

/// -1 for a mirrored camera, where a turn to the right goes the other way round in the world.
float CameraController::handedness() const {
  return glm::dot(glm::cross(right(), up()), forward()) < 0 ? 1.0f : -1.0f;
}

/// What the picture's height spans at the pivot [scene units].
float CameraController::view_height() const {
  const float height = 2 * tan_half_height_;
  return orthographic_ ? height * glm::length(Vec3(to_world_[1])) : height * pivot_distance_;
}

void CameraController::move(const std::function<void(CameraController&)>& motion) {
  CameraController moved = *this;
  motion(moved);
  const auto reach = [](const CameraController& camera) {
    const float distance = glm::length(camera.position());
    return camera.orthographic_ ? std::max(distance, camera.view_height()) : distance;
  };
  const bool can_stand =
      orthonormal_axes(moved.to_world_) && reach(moved) <= std::max(kEndOfTheWorld, reach(*this));
  if (can_stand) *this = moved;
}

void CameraController::orbit(Vec2 angles) { turn(angles, pivot()); }

void CameraController::look(Vec2 angles) { turn(angles, position()); }

void CameraController::turn(Vec2 angles, Vec3 center) {
  // The pitch first: a yaw around the axis of the world leaves it as it is.
  const float from_up = std::acos(std::clamp(glm::dot(forward(), world_up_), -1.0f, 1.0f));
  const float pitch = std::clamp(angles.y, std::min(0.0f, kPoleMargin - from_up),
                                 std::max(0.0f, kPi - kPoleMargin - from_up));
  const float sign = -handedness();
  to_world_ = rotation_around(center, sign * pitch, right()) * to_world_;
  to_world_ = rotation_around(center, sign * angles.x, world_up_) * to_world_;
}

void CameraController::pan(Vec2 share) {
  const Vec3 offset = (-share.x * right() + share.y * up()) * view_height();
  to_world_[3] += Vec4(offset, 0);
}

void CameraController::dolly(float steps) {
  const float factor = std::pow(kDollyFactor, steps);
  if (orthographic_) {
    const float height = view_height();
    const float scale = zoomed(height, factor) / height;
    to_world_[0] *= scale;
    to_world_[1] *= scale;
    return;
  }
  const float distance = zoomed(pivot_distance_, factor);
  to_world_[3] += Vec4(forward() * (pivot_distance_ - distance), 0);
  pivot_distance_ = distance;
}

/// Within what the scene's size makes sensible; a size that is not comes no farther from it.
float CameraController::zoomed(float size, float factor) const {
  return std::clamp(size * factor, std::min(size, kNearest * scene_radius_),
                    std::max(size, kFarthest * scene_radius_));
}

void CameraController::fly(Vec3 offset) {
  to_world_[3] += Vec4(offset.x * right() + offset.y * up() + offset.z * forward(), 0);
}

void CameraController::frame(const Bounds& bounds) {
  if (bounds.empty() || !(bounds.radius() > 0)) return;
  const float tan_half = std::min(tan_half_height_, tan_half_width_);
  if (orthographic_) {
    const float scale = bounds.radius() / (tan_half * glm::length(Vec3(to_world_[1])));
    to_world_[0] *= scale;
    to_world_[1] *= scale;
    set_pivot_distance(2 * bounds.radius());
  } else {
    // A sphere touches the sides of the picture at the distance radius / sin(half the field of
    // view).
    set_pivot_distance(bounds.radius() * std::sqrt(1 + sqr(tan_half)) / tan_half);
  }
  to_world_[3] = Vec4(bounds.center() - pivot_distance_ * forward(), 1);
}

std::optional<float> pivot_distance(const Scene& scene) {
  const Camera& camera = scene.camera();
  const Vec2 middle = 0.5f * Vec2(camera.width(), camera.height());
  const Ray ray = camera.sample_ray(middle, Vec2(0.5f)).ray;
  const Hit hit = scene.intersect(ray);
  if (!hit.valid()) return std::nullopt;
  const Vec3 target = ray.origin + hit.t * ray.direction;
  return glm::dot(target - camera.position(), camera.forward());
}

}  // namespace guidelight

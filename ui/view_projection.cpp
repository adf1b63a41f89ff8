#include "ui/view_projection.h"

#include <algorithm>

namespace guidelight {
namespace {

/// Where the ray through a raster position meets the plane at unit distance (orthographic: at the
/// camera), relative to the eye.
Vec3 on_picture_plane(const Camera& camera, Vec2 raster, bool parallel) {
  const CameraSample sample = camera.sample_ray(raster, Vec2(0.5f));
  if (parallel) return sample.lens_position - camera.position();
  return sample.ray.direction / glm::dot(sample.ray.direction, camera.forward());
}

}  // namespace

ViewProjection::ViewProjection(const Camera& camera, Vec2 origin, float scale, float near,
                               float far)
    : eye_(camera.position()),
      forward_(camera.forward()),
      parallel_(camera.description().model == CameraModel::Orthographic),
      near_(near),
      far_(far) {
  const Vec3 corner = on_picture_plane(camera, {0, 0}, parallel_);
  // By one pixel; differences over the whole picture lose fewer digits.
  const auto width = static_cast<float>(camera.width());
  const auto height = static_cast<float>(camera.height());
  const Vec3 right = (on_picture_plane(camera, {width, 0}, parallel_) - corner) / width;
  const Vec3 below = (on_picture_plane(camera, {0, height}, parallel_) - corner) / height;
  across_ = right * (scale / length_squared(right));
  down_ = below * (scale / length_squared(below));
  offset_ = origin - Vec2(glm::dot(corner, across_), glm::dot(corner, down_));
}

Vec2 ViewProjection::weighted_screen(Vec3 point) const {
  const Vec3 q = point - eye_;
  return offset_ * weight(point) + Vec2(glm::dot(q, across_), glm::dot(q, down_));
}

std::optional<Vec2> ViewProjection::to_screen(Vec3 point) const {
  if (depth(point) < near_) return std::nullopt;
  return weighted_screen(point) / weight(point);
}

std::optional<ViewProjection::Line> ViewProjection::to_screen(Vec3 a, Vec3 b) const {
  const float depth_a = depth(a) - near_;
  const float depth_b = depth(b) - near_;
  if (depth_a < 0 && depth_b < 0) return std::nullopt;
  Line line{{}, {}, 0, 1};
  if (depth_a < 0) line.from = depth_a / (depth_a - depth_b);
  if (depth_b < 0) line.to = depth_a / (depth_a - depth_b);
  const auto at = [&](float share) {
    const Vec3 point = glm::mix(a, b, share);
    return weighted_screen(point) / weight(point);
  };
  line.a = at(line.from);
  line.b = at(line.to);
  return line;
}

Ray ViewProjection::ray_through(Vec2 screen) const {
  const Vec2 relative = screen - offset_;
  const Vec3 in_plane = across_ * (relative.x / length_squared(across_)) +
                        down_ * (relative.y / length_squared(down_));
  if (parallel_) return {eye_ + in_plane, forward_, kInfinity};
  return {eye_, glm::normalize(in_plane + forward_), kInfinity};
}

Vec3 ViewProjection::seen_from(Vec3 point) const {
  return parallel_ ? point - depth(point) * forward_ : eye_;
}

float ViewProjection::pixels_per_unit(Vec3 point) const {
  return depth(point) < near_ ? 0 : glm::length(across_) / weight(point);
}

Mat4 ViewProjection::clip_from_world(Vec2 corner, Vec2 size) const {
  // Screen to -1 … 1, upper edge at -1.
  const Vec2 stretch = 2.0f / size;
  const Vec2 shifted = (offset_ - corner) * stretch - 1.0f;
  const Vec3 x = across_ * stretch.x + (parallel_ ? Vec3(0) : shifted.x * forward_);
  const Vec3 y = down_ * stretch.y + (parallel_ ? Vec3(0) : shifted.y * forward_);
  const float range = far_ - near_;
  const Vec3 z = forward_ * (parallel_ ? 2 / range : (far_ + near_) / range);
  const Vec3 w = parallel_ ? Vec3(0) : forward_;
  const Vec4 constant = parallel_ ? Vec4(shifted, -(far_ + near_) / range, 1)
                                  : Vec4(0, 0, -2 * far_ * near_ / range, 0);
  const Vec4 rows[] = {
      Vec4(x, constant.x - glm::dot(x, eye_)), Vec4(y, constant.y - glm::dot(y, eye_)),
      Vec4(z, constant.z - glm::dot(z, eye_)), Vec4(w, constant.w - glm::dot(w, eye_))};
  return glm::transpose(Mat4(rows[0], rows[1], rows[2], rows[3]));
}

ViewProjection project_scene(const Camera& camera, Vec2 origin, float scale, const Bounds& bounds) {
  constexpr float kNearShare = 5e-3f;
  const float radius = bounds.empty() ? 1.0f : std::max(bounds.radius(), 1e-6f);
  const float distance = bounds.empty() ? 0.0f : glm::length(bounds.center() - camera.position());
  return {camera, origin, scale, kNearShare * radius, distance + 2 * radius};
}

}  // namespace guidelight

#include "renderer/scene/camera.h"

#include "renderer/error.h"
#include "renderer/math/axes.h"
#include "renderer/sampling/warp.h"
#include "renderer/scene/field_of_view.h"
#include "renderer/scene/reach.h"

namespace guidelight {

namespace {

void check_film(const FilmDescription& film) {
  if (film.width <= 0 || film.height <= 0) {
    throw Error("the film has {}x{} pixels: give it at least one", film.width, film.height);
  }
  if (film.crop_width == 0) return;
  const bool inside = film.crop_x >= 0 && film.crop_y >= 0 && film.crop_width > 0 &&
                      film.crop_height > 0 && film.crop_width <= film.width - film.crop_x &&
                      film.crop_height <= film.height - film.crop_y;
  if (!inside) {
    throw Error(
        "the crop window of {}x{} pixels at ({}, {}) is not inside the film of {}x{}: move it "
        "inside",
        film.crop_width, film.crop_height, film.crop_x, film.crop_y, film.width, film.height);
  }
}

void check_camera(const CameraDescription& camera) {
  if (!(camera.fov > 0 && camera.fov < 180)) {
    throw Error("the camera's field of view is {} degrees: give an angle between 0 and 180",
                camera.fov);
  }
  if (!(camera.near_clip >= 0 && camera.far_clip > camera.near_clip)) {
    throw Error("the camera's clip distances are {} and {}: give the near one first, and positive",
                camera.near_clip, camera.far_clip);
  }
  const bool has_lens = camera.model == CameraModel::ThinLens;
  if (has_lens && !(camera.aperture_radius >= 0 && camera.focus_distance > 0)) {
    throw Error(
        "the camera's aperture radius is {} and its focus distance {}: give positive numbers",
        camera.aperture_radius, camera.focus_distance);
  }
}

}  // namespace

Camera::Camera(const CameraDescription& camera, const FilmDescription& film)
    : description_(camera), film_(film), position_(camera.to_world[3]) {
  check_film(film);
  check_camera(camera);
  width_ = film.crop_width > 0 ? film.crop_width : film.width;
  height_ = film.crop_width > 0 ? film.crop_height : film.height;

  const auto axes = orthonormal_axes(camera.to_world);
  if (!axes) {
    throw Error(
        "the camera's transform is singular or not finite: give it one that can be inverted");
  }
  axes_ = *axes;

  // Scaled axes stretch an orthographic picture; a perspective one only if they are scaled
  // differently.
  const bool orthographic = camera.model == CameraModel::Orthographic;
  const Mat3 linear(camera.to_world);
  const Vec2 scale(glm::length(linear[0]), glm::length(linear[1]));
  const Vec2 stretch = scale / (orthographic ? 1.0f : glm::length(linear[2]));
  const float aspect = static_cast<float>(film.width) / static_cast<float>(film.height);
  const Vec2 half = stretch * (orthographic ? Vec2(1, 1 / aspect)
                                            : half_extent(camera.fov, camera.fov_axis, aspect));
  plane_per_pixel_ = -2.0f * half / Vec2(film.width, film.height);
  const Vec2 first_pixel = Vec2(film.crop_x, film.crop_y) * (film.crop_width > 0 ? 1.0f : 0.0f) +
                           camera.principal_point_offset * Vec2(film.width, film.height);
  plane_origin_ = half + first_pixel * plane_per_pixel_;
  inverse_area_ = 1 / (plane_per_pixel_.x * plane_per_pixel_.y * width_ * height_);
  margin_ = std::max(0.0f, filter_radius(film.filter) - 0.5f);

  if (camera.model == CameraModel::ThinLens && camera.aperture_radius > 0) {
    lens_radius_ = camera.aperture_radius;
    inverse_lens_area_ = kInvPi / sqr(lens_radius_);
    inverse_focus_distance_ = 1 / camera.focus_distance;
  }
  check_reach();
}

void Camera::check_reach() const {
  const Vec2 corner = glm::max(glm::abs(plane_of(Vec2(-margin_))),
                               glm::abs(plane_of(Vec2(width_, height_) + margin_)));
  const float slope = corner.x + corner.y + lens_radius_ * inverse_focus_distance_;
  const Vec3 reach(slope, lens_radius_, description_.near_clip * (1 + slope));
  if (!is_within(position_, kLargestCoordinate) || !is_within(reach, kLargestCoordinate)) {
    throw Error(
        "the camera's position, near clip distance, lens or picture reaches farther than {} from "
        "the origin: give smaller numbers",
        kLargestCoordinate);
  }
}

Camera Camera::with_transform(const Mat4& to_world) const {
  CameraDescription camera = description_;
  camera.to_world = to_world;
  return {camera, film_};
}

Camera Camera::with_resolution(int width, int height) const {
  FilmDescription film = film_;
  if (film.crop_width > 0) {
    const Vec2 scale = Vec2(width, height) / Vec2(width_, height_);
    film.crop_x = static_cast<int>(std::lround(film.crop_x * scale.x));
    film.crop_y = static_cast<int>(std::lround(film.crop_y * scale.y));
    film.width = std::max(static_cast<int>(std::lround(film.width * scale.x)), film.crop_x + width);
    film.height =
        std::max(static_cast<int>(std::lround(film.height * scale.y)), film.crop_y + height);
    film.crop_width = width;
    film.crop_height = height;
  } else {
    film.width = width;
    film.height = height;
  }
  return {description_, film};
}

CameraSample Camera::sample_ray(Vec2 raster, Vec2 u_lens) const {
  const Vec2 plane = plane_of(raster);
  const float near = description_.near_clip;
  const float depth = description_.far_clip - near;
  CameraSample sample;
  sample.weight = Color(1);
  if (description_.model == CameraModel::Orthographic) {
    sample.lens_position = position_ + axes_[0] * plane.x + axes_[1] * plane.y;
    sample.ray = {sample.lens_position + near * axes_[2], axes_[2], depth};
    sample.pdf_direction = inverse_area_;
    return sample;
  }
  // Through the lens, the point of the plane in focus stays where the pinhole sees it.
  Vec2 lens(0);
  if (lens_radius_ > 0) lens = lens_radius_ * square_to_disk(u_lens);
  const Vec2 slope = plane - lens * inverse_focus_distance_;
  const float length = std::sqrt(1 + glm::dot(slope, slope));  // 1/cosθ
  sample.lens_position = position_ + axes_[0] * lens.x + axes_[1] * lens.y;
  const Vec3 direction = axes_[0] * slope.x + axes_[1] * slope.y + axes_[2];
  sample.ray = {sample.lens_position + near * direction, direction / length, depth * length};
  sample.pdf_direction = inverse_area_ * length * length * length;
  return sample;
}

bool Camera::is_seen(Vec2 raster) const {
  const Vec2 end = Vec2(width_, height_) + margin_;
  return raster.x >= -margin_ && raster.y >= -margin_ && raster.x < end.x && raster.y < end.y;
}

std::optional<Vec2> Camera::raster_of_plane(Vec2 plane) const {
  const Vec2 raster = (plane - plane_origin_) / plane_per_pixel_;
  return is_seen(raster) ? std::optional(raster) : std::nullopt;
}

std::optional<Vec2> Camera::raster_of(Vec3 lens_position, Vec3 w) const {
  const Vec2 lens(to_local(lens_position - position_));
  if (description_.model == CameraModel::Orthographic) return raster_of_plane(lens);
  const Vec3 local = to_local(w);
  if (!(local.z > 0)) return std::nullopt;
  return raster_of_plane(Vec2(local) / local.z + lens * inverse_focus_distance_);
}

std::optional<CameraConnection> Camera::connect(Vec3 point, Vec2 u_lens) const {
  const Vec3 local = to_local(point - position_);
  if (!(local.z >= description_.near_clip && local.z <= description_.far_clip)) return std::nullopt;

  CameraConnection connection;
  if (description_.model == CameraModel::Orthographic) {
    const auto raster = raster_of_plane(Vec2(local));
    if (!raster) return std::nullopt;
    connection.raster = *raster;
    connection.lens_position = point - local.z * axes_[2];
    connection.direction = -axes_[2];
    connection.distance = local.z;
    connection.importance = sqr(local.z) * inverse_area_;
    connection.pdf_lens = 1;
    connection.cos_camera = 1;
    connection.pdf_direction = inverse_area_;
    return connection;
  }

  Vec2 lens(0);
  if (lens_radius_ > 0) lens = lens_radius_ * square_to_disk(u_lens);
  const Vec2 slope = (Vec2(local) - lens) / local.z;
  const auto raster = raster_of_plane(slope + lens * inverse_focus_distance_);
  if (!raster) return std::nullopt;
  connection.raster = *raster;
  connection.lens_position = position_ + axes_[0] * lens.x + axes_[1] * lens.y;
  const float inverse_cos = std::sqrt(1 + glm::dot(slope, slope));
  connection.distance = local.z * inverse_cos;
  connection.direction = (connection.lens_position - point) / connection.distance;
  connection.cos_camera = 1 / inverse_cos;
  connection.pdf_direction = inverse_area_ * inverse_cos * inverse_cos * inverse_cos;
  connection.pdf_lens = inverse_lens_area_;
  connection.importance = connection.pdf_direction * inverse_cos * inverse_lens_area_;
  return connection;
}

float Camera::pdf_direction(Vec3 lens_position, Vec3 w) const {
  if (!raster_of(lens_position, w)) return 0;
  if (description_.model == CameraModel::Orthographic) return inverse_area_;
  const float cosine = glm::dot(axes_[2], w);
  return inverse_area_ / (cosine * cosine * cosine);
}

float Camera::importance(Vec3 lens_position, Vec3 w) const {
  const float pdf = pdf_direction(lens_position, w);
  if (description_.model == CameraModel::Orthographic || pdf == 0) return pdf;
  return pdf * inverse_lens_area_ / glm::dot(axes_[2], w);
}

}  // namespace guidelight

#pragma once

#include <optional>

#include "renderer/math/ray.h"
#include "renderer/scene/description.h"

namespace guidelight {

/// A ray through the film.
struct CameraSample {
  Ray ray;       // unit direction; t_max is the far clip, the origin is moved to the near clip
  Color weight;  // We/pdf: 1 for these cameras
  Vec3 lens_position;
  float pdf_direction;  // per solid angle, of the whole picture sampled uniformly (see Camera)
};

/// Connection of a point to the camera.
struct CameraConnection {
  Vec3 lens_position;
  Vec3 direction;    // unit, from the point to the lens (orthographic: against the view direction)
  float distance;
  Vec2 raster;       // [pixels], inside the picture
  float importance;  // We of the pixel filter's unit volume: contribution = f·importance·G/pdf...
  float pdf_lens;    // per area on the lens; 1 (discrete) for a pinhole
  float cos_camera;  // cosine of the ray at the lens
  float pdf_direction;  // per solid angle, of a picture sampled uniformly
};

/// Projective camera: pinhole, thin lens or orthographic, with importance for light paths.
///
/// Densities refer to a picture that is sampled uniformly over its W×H pixels: pdf_direction = 1/(A·cos³θ)
/// with A the picture's area at unit distance (for orthographic cameras the position density 1/A takes its
/// place). The importance We = 1/(A·A_lens·cos⁴θ) is normalised to ∫We dA cosθ dω = 1 over lens and
/// picture (Pharr et al., Physically Based Rendering, 16.1); a light path's contribution to pixel j is then
/// W·H · f · We. Immutable; copies are cheap.
class Camera {
 public:
  /// Throws Error for a film without pixels or a singular transform.
  Camera(const CameraDescription& camera, const FilmDescription& film);

  int width() const { return width_; }
  int height() const { return height_; }
  const CameraDescription& description() const { return description_; }
  const FilmDescription& film() const { return film_; }

  /// The same view with another transform / on a picture of another size.
  Camera with_transform(const Mat4& to_world) const;
  Camera with_resolution(int width, int height) const;

  /// raster: [pixels] in [0,W)×[0,H), y down; u_lens chooses the point on the lens.
  CameraSample sample_ray(Vec2 raster, Vec2 u_lens) const;

  /// Empty if the point is not in the picture (or behind the camera, or clipped).
  std::optional<CameraConnection> connect(Vec3 point, Vec2 u_lens) const;

  /// Raster position that sees along unit direction `w` from a lens point; empty outside the picture.
  std::optional<Vec2> raster_of(Vec3 lens_position, Vec3 w) const;

  /// Density of choosing unit direction w (see above), 0 outside the picture.
  float pdf_direction(Vec3 lens_position, Vec3 w) const;
  /// We(lens_position, w), 0 outside the picture.
  float importance(Vec3 lens_position, Vec3 w) const;

  bool has_pinhole() const { return lens_radius_ == 0; }
  Vec3 position() const { return Vec3(to_world_[3]); }
  Vec3 forward() const;
  /// Width of one pixel at unit distance along the view direction: the footprint of primary rays.
  float pixel_size_at_unit_distance() const { return pixel_size_; }

 private:
  CameraDescription description_;
  FilmDescription film_;
  int width_;
  int height_;
  Mat4 to_world_;
  Mat4 to_local_;
  Vec2 image_min_;   // the picture at unit distance (orthographic: in local units), x to the left
  Vec2 image_size_;
  float image_area_;
  float lens_radius_ = 0;
  float lens_area_ = 1;
  float pixel_size_ = 0;
};

}  // namespace guidelight

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
  Vec3 direction;  // unit, from the point to the lens (orthographic: against the view direction)
  float distance;
  Vec2 raster;          // [pixels], inside the picture or its margin
  float importance;     // We, see Camera::connect
  float pdf_lens;       // per area on the lens; 1 (discrete) for a pinhole
  float cos_camera;     // cosine of the ray at the lens
  float pdf_direction;  // per solid angle, of a picture sampled uniformly
};

/// Projective camera: pinhole, thin lens or orthographic, with importance for light paths.
///
/// Densities refer to a picture that is sampled uniformly over its W×H pixels: pdf_direction =
/// 1/(A·cos³θ) with A the picture's area at unit distance (for orthographic cameras the position
/// density 1/A takes its place). The importance We = 1/(A·A_lens·cos⁴θ) is normalised to ∫We dA
/// cosθ dω = 1 over lens and picture (Pharr et al., Physically Based Rendering, 16.1); a light
/// path's contribution to pixel j is then W·H · f · We. Filters reach beyond the picture's edge,
/// and so do rays, connections and importance, by a margin of the filter's radius. Immutable;
/// copies are cheap.
class Camera {
 public:
  /// Throws Error for a film without pixels, a crop window outside it, a singular transform, a
  /// field of view, aperture, focus or clip distance that means nothing, or rays that would start
  /// beyond kLargestCoordinate.
  Camera(const CameraDescription& camera, const FilmDescription& film);

  int width() const { return width_; }
  int height() const { return height_; }
  const CameraDescription& description() const { return description_; }
  const FilmDescription& film() const { return film_; }

  /// The same view with another transform / on a picture of another size.
  Camera with_transform(const Mat4& to_world) const;
  Camera with_resolution(int width, int height) const;

  /// raster: [pixels], y down, the picture is [0,W)×[0,H) (pixel filters reach a little beyond);
  /// u_lens chooses the point on the lens.
  CameraSample sample_ray(Vec2 raster, Vec2 u_lens) const;

  /// Empty if no pixel sees the point (or it is behind the camera, or clipped). The contribution
  /// of a light path that ends at the point is W·H · throughput · value(direction) · importance ·
  /// cos_camera / (distance² · pdf_lens). For orthographic cameras, whose direction is a delta,
  /// `importance` is distance²/A, which makes the same formula hold.
  std::optional<CameraConnection> connect(Vec3 point, Vec2 u_lens) const;

  /// Raster position that sees along unit direction `w` from a lens point; empty if no pixel's
  /// filter reaches it.
  std::optional<Vec2> raster_of(Vec3 lens_position, Vec3 w) const;

  /// A uniform raster position within the margin.
  Vec2 sample_raster(Vec2 u) const { return u * (Vec2(width_, height_) + 2 * margin_) - margin_; }
  /// Whether a pixel's filter reaches a raster position.
  bool is_seen(Vec2 raster) const;
  /// The area within the margin over the picture's: pdf_direction over the density of directions by
  /// sample_raster().
  float raster_excess() const {
    return (1 + 2 * margin_ / static_cast<float>(width_)) *
           (1 + 2 * margin_ / static_cast<float>(height_));
  }

  /// Density of choosing unit direction w (see above), 0 where no pixel sees.
  float pdf_direction(Vec3 lens_position, Vec3 w) const;
  /// We(lens_position, w), 0 where no pixel sees.
  float importance(Vec3 lens_position, Vec3 w) const;

  bool has_pinhole() const { return lens_radius_ == 0; }
  Vec3 position() const { return position_; }
  Vec3 forward() const { return axes_[2]; }
  /// Width of one pixel at unit distance along the view direction: the footprint of primary rays
  /// (orthographic: at any distance).
  float pixel_size_at_unit_distance() const { return -plane_per_pixel_.x; }

 private:
  void check_reach() const;
  Vec2 plane_of(Vec2 raster) const { return plane_origin_ + raster * plane_per_pixel_; }
  std::optional<Vec2> raster_of_plane(Vec2 plane) const;
  Vec3 to_local(Vec3 w) const { return w * axes_; }

  CameraDescription description_;
  FilmDescription film_;
  int width_;
  int height_;
  Vec3 position_;
  Mat3 axes_;  // orthonormal columns: left, up, forward in world space; left-handed if mirrored
  // The picture's plane: at unit distance, for orthographic cameras through the position. Its x
  // runs to the left and its y up, so pixels have negative extent.
  Vec2 plane_origin_;
  Vec2 plane_per_pixel_;
  float inverse_area_;  // of the picture in its plane
  float margin_;        // how far filters reach beyond the picture [pixels]
  float lens_radius_ = 0;
  float inverse_lens_area_ = 1;
  float inverse_focus_distance_ = 0;
};

}  // namespace guidelight

#pragma once

#include <cmath>

#include "renderer/transport/path.h"

namespace guidelight {

/// A distance or angle drawn so that every order of magnitude between two limits is as likely
/// (Veach 1997, 11.3.2); the direction of the offset is uniform.
class LogUniform {
 public:
  LogUniform(float min, float max) : min_(min), max_(max), log_ratio_(std::log(max / min)) {}

  float sample(float u) const { return max_ * std::exp(-log_ratio_ * u); }
  float pdf(float x) const { return x >= min_ && x <= max_ ? 1 / (x * log_ratio_) : 0.0f; }

 private:
  float min_;
  float max_;
  float log_ratio_;
};

/// A unit direction at an angle [rad] from another one, turned around it by 2πu.
Vec3 deflect(Vec3 direction, float angle, float u);
/// Angle between unit directions [rad], also of tiny ones.
float angle_between(Vec3 a, Vec3 b);
/// Density per solid angle of a deflection whose angle has this density.
inline float deflection_pdf(float pdf_angle, float angle) {
  return pdf_angle / (2 * kPi * std::sin(angle));
}

/// Densities of vertices that follow from a direction alone: from vertex `from`, which draws it
/// with `pdf_direction`, over specular vertices to vertex `to`, in the measure of Path.
double chain_pdf_to_eye(const Path& path, int from, int to, double pdf_direction);
double chain_pdf_to_light(const Path& path, int from, int to, double pdf_direction);

/// Whether two paths scatter alike at every vertex.
bool same_form(const Path& a, const Path& b);

/// Angle by which a path's first vertex seen from the eye appears to move by one pixel [rad].
float pixel_angle(const Scene& scene, const Path& path);

}  // namespace guidelight

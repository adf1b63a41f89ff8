#include "renderer/metropolis/perturbation.h"

#include <cmath>

namespace guidelight {

Vec3 deflect(Vec3 direction, float angle, float u) {
  const float phi = 2 * kPi * u;
  const float sine = std::sin(angle);
  return glm::normalize(Frame::from_normal(direction).to_world(
      {sine * std::cos(phi), sine * std::sin(phi), std::cos(angle)}));
}

float angle_between(Vec3 a, Vec3 b) {
  return 2 * std::atan2(glm::length(a - b), glm::length(a + b));
}

double chain_pdf_to_eye(const Path& path, int from, int to, double pdf_direction) {
  double pdf = pdf_direction;
  for (int i = from; i < to; ++i) pdf *= path.points[i].arrival_eye;
  return pdf;
}

double chain_pdf_to_light(const Path& path, int from, int to, double pdf_direction) {
  double pdf = pdf_direction;
  for (int i = from; i > to; --i) {
    pdf *= path.points[i - 1].arrival_light;
    if (i < from) pdf *= path.points[i].jacobian;
  }
  return to == 0 ? pdf * path.hit_probability() : pdf;
}

bool same_form(const Path& a, const Path& b) {
  if (a.size() != b.size()) return false;
  for (int i = 0; i < a.size(); ++i) {
    if (a.points[i].event != b.points[i].event) return false;
  }
  return true;
}

float pixel_angle(const Scene& scene, const Path& path) {
  const float size = scene.camera().pixel_size_at_unit_distance();
  if (scene.camera().description().model != CameraModel::Orthographic) return size;
  return size / path.points[path.size() - 2].distance;
}

}  // namespace guidelight

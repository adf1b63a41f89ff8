#pragma once

#include "renderer/math/vector.h"

namespace guidelight {

/// What a smooth interface between two dielectrics does to unpolarised light.
struct DielectricFresnel {
  float reflectance;      // share of the flux that is reflected, 1 - transmitted share
  float cos_transmitted;  // ≥ 0, of the refracted direction; 0 at total internal reflection
  float eta;              // IOR behind the interface over IOR in front of it, as seen by the light
};

/// cos_theta is signed: positive on the outside, where the IOR is 1/eta of the inside's.
inline DielectricFresnel fresnel_dielectric(float cos_theta, float eta) {
  const float relative = cos_theta >= 0 ? eta : 1 / eta;
  const float cos_i = std::abs(cos_theta);
  const float cos2_t = 1 - (1 - cos_i * cos_i) / (relative * relative);  // Snell
  if (cos2_t <= 0) return {1.0f, 0.0f, relative};
  const float cos_t = std::sqrt(cos2_t);
  const float r_s = (cos_i - relative * cos_t) / (cos_i + relative * cos_t);
  const float r_p = (relative * cos_i - cos_t) / (relative * cos_i + cos_t);
  return {0.5f * (r_s * r_s + r_p * r_p), cos_t, relative};
}

/// Reflectance of a conductor with complex IOR eta + i·k relative to the outside.
inline Color fresnel_conductor(float cos_theta, Color eta, Color k) {
  const float cos2 = cos_theta * cos_theta;
  const float sin2 = std::max(0.0f, 1 - cos2);
  const Color difference = eta * eta - k * k - sin2;
  const Color a2_plus_b2 = glm::sqrt(difference * difference + 4.0f * eta * eta * k * k);
  const Color a = glm::sqrt(glm::max(0.5f * (a2_plus_b2 + difference), Color(0.0f)));
  const Color r_s = (a2_plus_b2 + cos2 - 2.0f * cos_theta * a) /
                    (a2_plus_b2 + cos2 + 2.0f * cos_theta * a + 1e-30f);
  const Color t1 = cos2 * a2_plus_b2 + sin2 * sin2;
  const Color t2 = 2.0f * cos_theta * sin2 * a;
  const Color r_p = r_s * (t1 - t2) / (t1 + t2 + 1e-30f);
  return 0.5f * (r_s + r_p);
}

/// Reflectance of a smooth interface under diffuse illumination from the side where the other
/// side's relative IOR is eta: ∫ F(μ)·2μ dμ, by quadrature.
float diffuse_fresnel_reflectance(float eta);

/// Mirrors a unit direction at z, and at a unit normal.
inline Vec3 reflect(Vec3 w) { return {-w.x, -w.y, w.z}; }
inline Vec3 reflect(Vec3 w, Vec3 normal) { return 2 * glm::dot(w, normal) * normal - w; }

/// Refracts a unit direction at z, and at a unit normal; `fresnel` belongs to cosθ = w·normal.
inline Vec3 refract(Vec3 w, const DielectricFresnel& fresnel) {
  const float scale = -1 / fresnel.eta;
  return {w.x * scale, w.y * scale, -std::copysign(fresnel.cos_transmitted, w.z)};
}
inline Vec3 refract(Vec3 w, Vec3 normal, const DielectricFresnel& fresnel) {
  const float cos_i = glm::dot(w, normal);
  const float cos_t = std::copysign(fresnel.cos_transmitted, cos_i);
  return (cos_i / fresnel.eta - cos_t) * normal - w / fresnel.eta;
}

}  // namespace guidelight

#include "renderer/scene/bsdf/microfacet.h"

namespace guidelight {
namespace {

constexpr float kInvSqrtPi = 0.5641895835f;

/// Inverse error function to single precision (Giles 2010, "Approximating the erfinv function").
float inverse_erf(float x) {
  const float w = -std::log(std::max((1 - x) * (1 + x), 1e-30f));
  if (w < 5) {
    const float v = w - 2.5f;
    float p = 2.81022636e-08f;
    for (const float c : {3.43273939e-07f, -3.5233877e-06f, -4.39150654e-06f, 0.00021858087f,
                          -0.00125372503f, -0.00417768164f, 0.246640727f, 1.50140941f}) {
      p = c + p * v;
    }
    return p * x;
  }
  const float v = std::sqrt(w) - 3;
  float p = -0.000200214257f;
  for (const float c : {0.000100950558f, 0.00134934322f, -0.00367342844f, 0.00573950773f,
                        -0.0076224613f, 0.00943887047f, 1.00167406f, 2.83297682f}) {
    p = c + p * v;
  }
  return p * x;
}

/// Slope along the view direction of a visible Beckmann facet of roughness 1. With c = cot θ its
/// density is proportional to (c - x)·exp(-x²) for x < c (Heitz & d'Eon 2014, "Importance Sampling
/// Microfacet-Based BSDFs using the Distribution of Visible Normals", eq. 9). Its integral is
/// inverted in b = erf x, where it is nearly linear, by Newton steps kept inside a bracket.
float sample_beckmann_slope(float cot_theta, float u) {
  const auto integral = [cot_theta](float b, float x) {
    return cot_theta * (1 + b) + kInvSqrtPi * std::exp(-x * x);
  };
  float lower = -1;
  float upper = std::erf(cot_theta);
  const float target = u * integral(upper, cot_theta);
  float b = lower + (upper - lower) * u;
  float x = inverse_erf(b);
  for (int i = 0; i < 24; ++i) {
    const float error = integral(b, x) - target;
    if (std::abs(error) < 1e-6f * (1 + target)) break;
    (error > 0 ? upper : lower) = b;
    const float next = b - error / (cot_theta - x);  // d integral / d b
    b = next > lower && next < upper ? next : 0.5f * (lower + upper);
    x = inverse_erf(b);
  }
  return x;
}

/// Visible normal of an isotropic Beckmann surface of roughness 1.
Vec3 sample_visible_beckmann(Vec3 w, Vec2 u) {
  const float sin_theta = std::sqrt(w.x * w.x + w.y * w.y);
  const float cot_theta = w.z / std::max(sin_theta, 1e-6f);
  const Vec2 axis = sin_theta > 1e-6f ? Vec2(w.x, w.y) / sin_theta : Vec2(1, 0);
  const float along = sample_beckmann_slope(cot_theta, u.x);
  const float across = inverse_erf(2 * u.y - 1);
  return {-(axis.x * along - axis.y * across), -(axis.y * along + axis.x * across), 1};
}

/// Visible normal of an isotropic GGX surface of roughness 1, a hemisphere: the reflections of w by
/// it fill a spherical cap uniformly (Dupuy & Benyoub 2023, "Sampling Visible GGX Normals with
/// Spherical Caps").
Vec3 sample_visible_ggx(Vec3 w, Vec2 u) {
  const float phi = 2 * kPi * u.x;
  const float z = (1 - u.y) * (1 + w.z) - w.z;
  const float sin_theta = safe_sqrt(1 - z * z);
  return Vec3(sin_theta * std::cos(phi), sin_theta * std::sin(phi), z) + w;
}

}  // namespace

float MicrofacetDistribution::density(Vec3 m) const {
  if (m.z <= 0) return 0;
  const float cos2 = m.z * m.z;
  const float slope2 = (sqr(m.x / alpha_u_) + sqr(m.y / alpha_v_)) / cos2;
  const float area = kPi * alpha_u_ * alpha_v_ * cos2 * cos2;
  return kind_ == Microfacet::Beckmann ? std::exp(-slope2) / area       // (25)
                                       : 1 / (area * sqr(1 + slope2));  // (33)
}

float MicrofacetDistribution::masking(Vec3 w) const {
  const float tan2_alpha2 = (sqr(w.x * alpha_u_) + sqr(w.y * alpha_v_)) / (w.z * w.z);
  if (kind_ == Microfacet::Ggx) return 2 / (1 + std::sqrt(1 + tan2_alpha2));  // (34)
  if (tan2_alpha2 < 0.05f) return 1.0f;                                       // 1 - G₁ < 1e-9
  const float a = 1 / std::sqrt(tan2_alpha2);
  return 2 / (1 + std::erf(a) + kInvSqrtPi / a * std::exp(-a * a));  // (26)
}

Vec3 MicrofacetDistribution::sample_visible(Vec3 w, Vec2 u) const {
  const Vec3 stretched = glm::normalize(Vec3(alpha_u_ * w.x, alpha_v_ * w.y, w.z));
  const Vec3 m = kind_ == Microfacet::Ggx ? sample_visible_ggx(stretched, u)
                                          : sample_visible_beckmann(stretched, u);
  return glm::normalize(Vec3(alpha_u_ * m.x, alpha_v_ * m.y, std::max(m.z, 1e-7f)));
}

}  // namespace guidelight

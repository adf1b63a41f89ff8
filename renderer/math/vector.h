#pragma once

#include <cmath>
#include <glm/glm.hpp>
#include <limits>
#include <numbers>

namespace guidelight {

using Vec2 = glm::vec2;
using Vec3 = glm::vec3;
using Vec4 = glm::vec4;
using Mat3 = glm::mat3;
using Mat4 = glm::mat4;

/// Linear RGB with the sRGB (Rec. 709) primaries: radiance [W/(m² sr)], reflectance [1] or a
/// weight.
using Color = glm::vec3;

inline constexpr float kPi = std::numbers::pi_v<float>;
inline constexpr float kInvPi = std::numbers::inv_pi_v<float>;
inline constexpr float kInfinity = std::numeric_limits<float>::infinity();
inline constexpr float kFloatEpsilon = std::numeric_limits<float>::epsilon();
inline constexpr float kOneMinusEpsilon = 1.0f - 0.5f * kFloatEpsilon;

template <typename T>
constexpr T sqr(T x) {
  return x * x;
}

inline float safe_sqrt(float x) { return std::sqrt(std::max(x, 0.0f)); }

inline float length_squared(Vec3 v) { return glm::dot(v, v); }

/// Rec. 709 luminance.
inline float luminance(Color c) { return 0.2126f * c.r + 0.7152f * c.g + 0.0722f * c.b; }

inline float max_component(Vec3 v) { return std::max(v.x, std::max(v.y, v.z)); }
inline float min_component(Vec3 v) { return std::min(v.x, std::min(v.y, v.z)); }
inline bool is_black(Color c) { return c.r == 0 && c.g == 0 && c.b == 0; }
inline bool is_finite(Vec3 v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

inline Vec3 transform_point(const Mat4& m, Vec3 p) { return Vec3(m * Vec4(p, 1)); }
inline Vec3 transform_vector(const Mat4& m, Vec3 v) { return Mat3(m) * v; }

}  // namespace guidelight

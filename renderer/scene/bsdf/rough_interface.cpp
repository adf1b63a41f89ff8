#include "renderer/scene/bsdf/rough_interface.h"

#include <algorithm>

#include "renderer/scene/bsdf/fresnel.h"

namespace guidelight {
namespace {

constexpr int kCosines = 64;
constexpr int kRoughnesses = 16;
constexpr int kQuadrature = 24;  // points per dimension

/// Mean of weight(m) over the normals that are visible from a direction.
template <typename Weight>
float mean_over_visible(const MicrofacetDistribution& facets, Vec3 w, Weight weight) {
  double sum = 0;
  for (int i = 0; i < kQuadrature; ++i) {
    for (int j = 0; j < kQuadrature; ++j) {
      sum += weight(facets.sample_visible(w, Vec2(i + 0.5f, j + 0.5f) / float(kQuadrature)));
    }
  }
  return static_cast<float>(sum / (kQuadrature * kQuadrature));
}

Vec3 direction_at(float cos_theta) { return {safe_sqrt(1 - cos_theta * cos_theta), 0, cos_theta}; }

float directional_transmittance(const MicrofacetDistribution& facets, float eta, float cos_theta) {
  const Vec3 wo = direction_at(cos_theta);
  return mean_over_visible(facets, wo, [&](Vec3 m) {
    const DielectricFresnel fresnel = fresnel_dielectric(glm::dot(wo, m), eta);
    if (fresnel.reflectance == 1) return 0.0f;
    const Vec3 wi = refract(wo, m, fresnel);
    return wi.z < 0 ? (1 - fresnel.reflectance) * facets.masking(wi, m) : 0.0f;
  });
}

float directional_reflectance(const MicrofacetDistribution& facets, float eta, float cos_theta) {
  const Vec3 wo = direction_at(cos_theta);
  return mean_over_visible(facets, wo, [&](Vec3 m) {
    const Vec3 wi = reflect(wo, m);
    if (wi.z <= 0) return 0.0f;
    return fresnel_dielectric(glm::dot(wo, m), eta).reflectance * facets.masking(wi, m);
  });
}

}  // namespace

RoughInterface::RoughInterface(Microfacet kind, float eta, float alpha_min, float alpha_max)
    : alpha_min_(alpha_min),
      alpha_max_(alpha_max),
      rows_(alpha_max > alpha_min ? kRoughnesses : 1) {
  table_.reserve(static_cast<size_t>(rows_) * kCosines);
  for (int row = 0; row < rows_; ++row) {
    const float alpha = alpha_min + (alpha_max - alpha_min) * row / std::max(rows_ - 1, 1);
    const MicrofacetDistribution facets(kind, alpha, alpha);
    for (int i = 0; i < kCosines; ++i) {
      const float cos_theta = std::max(static_cast<float>(i) / (kCosines - 1), 1e-4f);
      table_.push_back(directional_transmittance(facets, eta, cos_theta));
    }
  }
}

float RoughInterface::transmittance(float cos_theta, float alpha) const {
  if (rows_ == 1) return row_value(0, cos_theta);
  const float position =
      std::clamp((alpha - alpha_min_) / (alpha_max_ - alpha_min_), 0.0f, 1.0f) * (rows_ - 1);
  const int row = std::min(static_cast<int>(position), rows_ - 2);
  return glm::mix(row_value(row, cos_theta), row_value(row + 1, cos_theta), position - row);
}

float RoughInterface::row_value(int row, float cos_theta) const {
  const float position = std::clamp(cos_theta, 0.0f, 1.0f) * (kCosines - 1);
  const int i = std::min(static_cast<int>(position), kCosines - 2);
  const float* values = &table_[static_cast<size_t>(row) * kCosines + i];
  return glm::mix(values[0], values[1], position - i);
}

float diffuse_rough_reflectance(Microfacet kind, float eta, float alpha) {
  constexpr int kSteps = 64;
  const MicrofacetDistribution facets(kind, alpha, alpha);
  double sum = 0;
  for (int i = 0; i < kSteps; ++i) {
    const float cos_theta = std::sqrt((i + 0.5f) / kSteps);  // 2μ dμ = d(μ²)
    sum += directional_reflectance(facets, eta, cos_theta);
  }
  return static_cast<float>(sum / kSteps);
}

}  // namespace guidelight

#pragma once

#include <array>
#include <cstdint>

#include "renderer/math/vector.h"

namespace guidelight {

enum class FilterKind { Box, Tent, Gaussian, Mitchell };

struct FilterSettings {
  FilterKind kind = FilterKind::Gaussian;
  float radius =
      0;  // [pixels]; 0: the kind's default, box 0.5, tent 1, Gaussian 4 stddev, Mitchell 2
  float stddev = 0.5f;  // Gaussian [pixels]
  float b = 1.0f / 3;   // Mitchell–Netravali
  float c = 1.0f / 3;
};

/// How far a filter reaches from a pixel's centre [pixels].
float filter_radius(const FilterSettings& settings);

/// Pixel reconstruction filter, applied by importance sampling (Ernst et al. 2006): a sample for a
/// pixel is taken at pixel centre + offset, the offset distributed like |f|, and counts with weight
/// ∫|f| · sign f where ∫f = 1. Each sample then touches one pixel only, so film tiles need no
/// locks.
class Filter {
 public:
  struct Sample {
    Vec2 offset;   // from the pixel centre [pixels]
    float weight;  // 1 for filters without negative lobes
  };

  explicit Filter(const FilterSettings& settings = {});

  Sample sample(Vec2 u) const;

  /// The other way round, for one axis: which pixel a contribution at raster coordinate x goes to.
  /// Pixel i is chosen in proportion to |f(x - (i + 0.5))|, and the weight makes the expectation at
  /// i equal f.
  struct PixelChoice {
    int pixel;
    float weight;
  };
  PixelChoice choose_pixel(float x, float u) const;
  /// Normalised filter value at an offset [pixels] from the centre: ∫ eval = 1 [1/pixel²].
  float eval(Vec2 offset) const;
  float radius() const { return radius_; }
  const FilterSettings& settings() const { return settings_; }

 private:
  struct Axis {
    float offset;
    float weight;
  };
  void tabulate();
  float exact_axis(float x) const;
  float eval_axis(float x) const;
  Axis sample_axis(float u) const;

  FilterSettings settings_;
  float radius_;
  float normalisation_ = 1;      // 1/∫f over one axis
  float absolute_integral_ = 1;  // ∫|f| / ∫f over one axis
  // For the kinds without a closed-form inverse: the CDF of |f| on [0, radius], and for the k-th
  // 256th of it the first cell that reaches beyond, where the search for u in that 256th begins.
  static constexpr int kTableSize = 256;
  std::array<float, kTableSize + 2> values_{};  // normalised f at the cells' ends; one to spare
  std::array<float, kTableSize + 1> cdf_{};
  std::array<uint8_t, kTableSize> first_cell_{};
};

}  // namespace guidelight

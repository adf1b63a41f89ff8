#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "renderer/math/vector.h"

namespace guidelight {

/// Statistics of a point at which the light of photons is measured, photon map after photon map,
/// within a radius that shrinks (Hachisuka et al. 2008, "Progressive Photon Mapping"; equations are
/// numbered in docs/integrators.md). Points that belong to one pixel may share them (Hachisuka and
/// Jensen 2009, "Stochastic Progressive Photon Mapping").
struct DensityEstimate {
  double emitted = 0;        // light paths of all passes
  float count = 0;           // N: photons within the radius, less what was given up for shrinking
  float radius_squared = 0;  // R²; 0 before the first measurement
  Color flux{0.0f};  // τ: Σ of throughput · f · photon power, not yet divided by `emitted`

  /// A pass of `light_paths` of which `found` photons (M) with the flux τ_M lay within the radius.
  void add_pass(double light_paths, int found, Color found_flux, float alpha) {
    emitted += light_paths;
    if (found == 0) return;
    const float m = static_cast<float>(found);
    const float kept = (count + alpha * m) / (count + m);
    count += alpha * m;                 // (P1)
    radius_squared *= kept;             // (P2)
    flux = (flux + found_flux) * kept;  // (P3)
  }

  /// (P4). By (P2) and (P3), τ/R² grows by τ_M/R² in every pass: this is the mean of the passes'
  /// own estimates, each with the radius of its time.
  Color radiance() const {
    if (!(emitted > 0 && radius_squared > 0)) return Color(0.0f);
    return flux * static_cast<float>(1 / (kPi * radius_squared * emitted));
  }

  /// Adds what another render of the same point found: densities and pictures add up.
  void merge(const DensityEstimate& other);
};

/// The density estimates of a film's pixels, and how far their radii may lead them astray.
class DensityEstimates {
 public:
  DensityEstimates() = default;
  DensityEstimates(int width, int height, int per_pixel);

  int per_pixel() const { return per_pixel_; }
  std::span<DensityEstimate> at(size_t pixel) {
    return {&estimates_[pixel * per_pixel_], static_cast<size_t>(per_pixel_)};
  }
  std::span<const DensityEstimate> at(size_t pixel) const {
    return {&estimates_[pixel * per_pixel_], static_cast<size_t>(per_pixel_)};
  }

  /// An estimate of the error of one sample, right in the mean and noisy.
  void add_bias(size_t pixel, double bias);

  /// Squared bias of the mean of all samples, for the pixels of rows [y0,y1). The square of a mean
  /// is too large by its variance, which is subtracted; what remains is averaged over blocks of
  /// pixels, because that of one pixel is mostly noise.
  std::vector<float> squared_bias(int y0, int y1) const;

  void merge(const DensityEstimates& other);
  /// Calls visit(number) for every number of the state of `self`, constant or not.
  template <typename Visit, typename Self>
  static void visit_state(Visit&& visit, Self& self);
  size_t state_size() const { return 6 * estimates_.size() + 3 * biases_.size(); }

 private:
  static constexpr int kBlock = 16;  // side [pixels]
  struct BiasSums {
    double sum = 0;
    double squares = 0;
    uint32_t samples = 0;
  };
  /// Mean over a block of pixels of the squared bias, at least 0.
  float block_squared_bias(int block_x, int block_y) const;

  int width_ = 0;
  int height_ = 0;
  int per_pixel_ = 0;
  std::vector<DensityEstimate> estimates_;
  std::vector<BiasSums> biases_;
};

template <typename Visit, typename Self>
void DensityEstimates::visit_state(Visit&& visit, Self& self) {
  for (auto& estimate : self.estimates_) {
    visit(estimate.emitted);
    visit(estimate.count);
    visit(estimate.radius_squared);
    for (int c = 0; c < 3; ++c) visit(estimate.flux[c]);
  }
  for (auto& bias : self.biases_) {
    visit(bias.sum);
    visit(bias.squares);
    visit(bias.samples);
  }
}

}  // namespace guidelight

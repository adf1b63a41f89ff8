#pragma once

#include <vector>

#include "renderer/math/frame.h"
#include "renderer/photons/irradiance_cache.h"

namespace guidelight {

/// Radiance over the hemisphere above a point, one sample in each of rings × sectors strata of
/// equal cosine-weighted solid angle.
class Hemisphere {
 public:
  struct Sample {
    Color radiance{0.0f};
    float distance = kInfinity;  // to what is seen there
  };

  /// About `count` strata, nearly square (Ward & Heckbert 1992 ask for π times as many sectors).
  Hemisphere(Vec3 position, Vec3 normal, int count);

  size_t size() const { return samples_.size(); }
  Sample& operator[](size_t i) { return samples_[i]; }
  /// A direction in the world within stratum i.
  Vec3 direction(size_t i, Vec2 u) const;

  /// Irradiance with its gradients and the harmonic mean distance.
  IrradianceRecord record() const;

 private:
  const Sample& at(int ring, int sector) const { return samples_[sector * rings_ + ring]; }
  /// sinθ of the boundary below a ring.
  float sin_theta(float ring) const { return std::sqrt(ring / static_cast<float>(rings_)); }
  float phi(float sector) const { return 2 * kPi * sector / static_cast<float>(sectors_); }
  void add_rotational(IrradianceRecord& record) const;
  void add_translational(IrradianceRecord& record) const;

  Vec3 position_;
  Frame frame_;
  int rings_;
  int sectors_;
  std::vector<Sample> samples_;
};

}  // namespace guidelight

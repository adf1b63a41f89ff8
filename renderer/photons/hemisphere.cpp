#include "renderer/photons/hemisphere.h"

#include <algorithm>

namespace guidelight {

Hemisphere::Hemisphere(Vec3 position, Vec3 normal, int count)
    : position_(position), frame_(Frame::from_normal(normal)) {
  const float n = static_cast<float>(std::max(count, 1));
  rings_ = std::max(1, static_cast<int>(std::lround(std::sqrt(n / kPi))));
  sectors_ = std::max(1, static_cast<int>(std::lround(n / static_cast<float>(rings_))));
  samples_.resize(static_cast<size_t>(rings_) * sectors_);
}

Vec3 Hemisphere::direction(size_t i, Vec2 u) const {
  const int ring = static_cast<int>(i) % rings_;
  const int sector = static_cast<int>(i) / rings_;
  const float sine = sin_theta(static_cast<float>(ring) + u.x);
  const float angle = phi(static_cast<float>(sector) + u.y);
  return frame_.to_world(
      {sine * std::cos(angle), sine * std::sin(angle), safe_sqrt(1 - sqr(sine))});
}

IrradianceRecord Hemisphere::record() const {
  IrradianceRecord record;
  record.position = position_;
  record.normal = frame_.n;
  const auto count = static_cast<float>(samples_.size());
  float inverse_distance = 0;
  for (const Sample& sample : samples_) {
    record.irradiance += sample.radiance * (kPi / count);
    inverse_distance += 1 / sample.distance;
  }
  record.distance = count / inverse_distance;
  add_rotational(record);
  add_translational(record);
  return record;
}

void Hemisphere::add_rotational(IrradianceRecord& record) const {
  // Ward & Heckbert 1992, (3), with the sign that belongs to a turn around n_i × n, and each
  // stratum's ∫ sinθ dω = (π/sectors) [θ - sinθ cosθ] in place of its centre's tanθ.
  const auto antiderivative = [&](int ring) {
    const float sine = sin_theta(static_cast<float>(ring));
    return std::asin(std::min(sine, 1.0f)) - sine * safe_sqrt(1 - sqr(sine));
  };
  for (int sector = 0; sector < sectors_; ++sector) {
    Color sum(0.0f);
    for (int ring = 0; ring < rings_; ++ring) {
      sum += at(ring, sector).radiance * (antiderivative(ring + 1) - antiderivative(ring));
    }
    const float angle = phi(static_cast<float>(sector) + 0.5f);
    const Vec3 axis = frame_.to_world({-std::sin(angle), std::cos(angle), 0});
    for (int c = 0; c < 3; ++c) record.rotational[c] += sum[c] * 0.5f * phi(1) * axis;
  }
}

void Hemisphere::add_translational(IrradianceRecord& record) const {
  // Ward & Heckbert 1992, (4): a step moves the boundaries between strata, the more the nearer what
  // is seen there.
  const float sector_angle = phi(1);
  for (int sector = 0; sector < sectors_; ++sector) {
    const int before = (sector + sectors_ - 1) % sectors_;
    Color between_rings(0.0f);
    Color between_sectors(0.0f);
    for (int ring = 0; ring < rings_; ++ring) {
      const Sample& here = at(ring, sector);
      const float sine = sin_theta(static_cast<float>(ring));
      const float width = sin_theta(static_cast<float>(ring) + 1) - sine;
      if (ring > 0) {
        const Sample& inner = at(ring - 1, sector);
        const float rate =
            sector_angle * sine * (1 - sqr(sine)) / std::min(here.distance, inner.distance);
        between_rings += rate * (here.radiance - inner.radiance);
      }
      const Sample& beside = at(ring, before);
      between_sectors +=
          width / std::min(here.distance, beside.distance) * (here.radiance - beside.radiance);
    }
    const float middle = phi(static_cast<float>(sector) + 0.5f);
    const float edge = phi(static_cast<float>(sector));
    const Vec3 outwards = frame_.to_world({std::cos(middle), std::sin(middle), 0});
    const Vec3 along = frame_.to_world({-std::sin(edge), std::cos(edge), 0});
    for (int c = 0; c < 3; ++c) {
      record.translational[c] += between_rings[c] * outwards + between_sectors[c] * along;
    }
  }
}

}  // namespace guidelight

#include "renderer/sampling/primary_samples.h"

#include <cmath>

namespace guidelight {

namespace {

/// A step of either sign, every order of magnitude between the two limits as likely (Kelemen et al.
/// 2002, section 4), around the unit circle.
float small_step(float value, Rng& rng) {
  constexpr float kMin = 1.0f / 1024;
  constexpr float kMax = 1.0f / 64;
  const float u = rng.next_float();
  const bool up = u < 0.5f;
  const float remapped = up ? 2 * u : 2 * u - 1;
  const float step = kMax * std::exp(-std::log(kMax / kMin) * remapped);
  const float moved = up ? value + step : value - step;
  const float wrapped = moved - std::floor(moved);
  return wrapped < 1 ? wrapped : 0.0f;
}

}  // namespace

void PrimarySamples::propose(bool large_step) {
  ++time_;
  large_step_ = large_step;
  next_ = 0;
}

void PrimarySamples::accept() {
  if (large_step_) last_large_step_ = time_;
}

void PrimarySamples::reject() {
  for (Coordinate& coordinate : coordinates_) {
    if (coordinate.time != time_) continue;
    coordinate.value = coordinate.old_value;
    coordinate.time = coordinate.old_time;
  }
  --time_;
}

float PrimarySamples::next_float() {
  if (next_ == coordinates_.size()) coordinates_.push_back({.value = rng_.next_float()});
  Coordinate& coordinate = coordinates_[next_++];
  update(coordinate);
  return coordinate.value;
}

void PrimarySamples::update(Coordinate& coordinate) {
  if (coordinate.time == time_) return;
  coordinate.old_value = coordinate.value;
  coordinate.old_time = coordinate.time;
  if (large_step_) {
    coordinate.value = rng_.next_float();
  } else {
    // What it missed while nobody asked.
    if (coordinate.time < last_large_step_) {
      coordinate.value = rng_.next_float();
      coordinate.time = last_large_step_;
    }
    for (; coordinate.time < time_; ++coordinate.time) {
      coordinate.value = small_step(coordinate.value, rng_);
    }
  }
  coordinate.time = time_;
}

}  // namespace guidelight

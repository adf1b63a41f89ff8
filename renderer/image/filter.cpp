#include "renderer/image/filter.h"

#include <algorithm>

namespace guidelight {

namespace {

float gaussian(float x, float stddev) { return std::exp(-0.5f * sqr(x / stddev)); }

/// Mitchell & Netravali 1988, equation 8, for |x| in [0,2].
float mitchell(float x, float b, float c) {
  if (x < 1) {
    return ((12 - 9 * b - 6 * c) * x * x * x + (-18 + 12 * b + 6 * c) * x * x + (6 - 2 * b)) / 6;
  }
  return ((-b - 6 * c) * x * x * x + (6 * b + 30 * c) * x * x + (-12 * b - 48 * c) * x +
          (8 * b + 24 * c)) /
         6;
}

}  // namespace

float filter_radius(const FilterSettings& settings) {
  if (settings.radius > 0) return settings.radius;
  switch (settings.kind) {
    case FilterKind::Box:
      return 0.5f;
    case FilterKind::Tent:
      return 1;
    case FilterKind::Gaussian:
      return 4 * settings.stddev;
    case FilterKind::Mitchell:
      break;
  }
  return 2;
}

Filter::Filter(const FilterSettings& settings) : settings_(settings) {
  if (!(settings_.stddev > 0)) settings_.stddev = FilterSettings().stddev;
  radius_ = filter_radius(settings_);
  switch (settings_.kind) {
    case FilterKind::Box:
      normalisation_ = 0.5f / radius_;
      break;
    case FilterKind::Tent:
      normalisation_ = 1 / radius_;
      break;
    case FilterKind::Gaussian:
    case FilterKind::Mitchell:
      tabulate();
      break;
  }
}

void Filter::tabulate() {
  constexpr int kPointsPerCell = 16;  // of the midpoint rule
  const double step = static_cast<double>(radius_) / (kTableSize * kPointsPerCell);
  double integral = 0;
  std::array<double, kTableSize + 1> sums{};
  for (int cell = 0; cell < kTableSize; ++cell) {
    sums[cell + 1] = sums[cell];
    for (int i = 0; i < kPointsPerCell; ++i) {
      const double f = exact_axis(static_cast<float>((cell * kPointsPerCell + i + 0.5) * step));
      integral += f * step;
      sums[cell + 1] += std::abs(f) * step;
    }
  }
  const double absolute = sums.back();
  normalisation_ = static_cast<float>(0.5 / integral);
  absolute_integral_ = static_cast<float>(absolute / integral);
  for (int i = 0; i <= kTableSize; ++i) cdf_[i] = static_cast<float>(sums[i] / absolute);
  cdf_.back() = 1;
  for (int i = 0; i <= kTableSize; ++i) {
    values_[i] = exact_axis(radius_ * static_cast<float>(i) / kTableSize);
  }
  int cell = 0;
  for (int k = 0; k < kTableSize; ++k) {
    while (cdf_[cell + 1] <= static_cast<float>(k) / kTableSize) ++cell;
    first_cell_[k] = static_cast<uint8_t>(cell);
  }
}

/// The filter (not yet normalised while it is tabulated) for x in [0, radius].
float Filter::exact_axis(float x) const {
  switch (settings_.kind) {
    case FilterKind::Box:
      return normalisation_;
    case FilterKind::Tent:
      return normalisation_ * (1 - x / radius_);
    case FilterKind::Gaussian:
      return normalisation_ * (gaussian(x, settings_.stddev) - gaussian(radius_, settings_.stddev));
    case FilterKind::Mitchell:
      break;
  }
  return normalisation_ * mitchell(2 * x / radius_, settings_.b, settings_.c);
}

float Filter::eval_axis(float x) const {
  x = std::abs(x);
  if (x > radius_) return 0;
  if (settings_.kind == FilterKind::Box || settings_.kind == FilterKind::Tent) return exact_axis(x);
  const float cell = x / radius_ * kTableSize;
  const int i = static_cast<int>(cell);
  return glm::mix(values_[i], values_[i + 1], cell - static_cast<float>(i));
}

float Filter::eval(Vec2 offset) const { return eval_axis(offset.x) * eval_axis(offset.y); }

Filter::Axis Filter::sample_axis(float u) const {
  const float side = u < 0.5f ? -1.0f : 1.0f;
  u = u < 0.5f ? 2 * u : 2 * u - 1;
  switch (settings_.kind) {
    case FilterKind::Box:
      return {side * radius_ * u, 1};
    case FilterKind::Tent:
      return {side * radius_ * (1 - std::sqrt(1 - u)), 1};
    case FilterKind::Gaussian:
    case FilterKind::Mitchell:
      break;
  }
  int cell = first_cell_[static_cast<int>(u * kTableSize)];
  while (cdf_[cell + 1] <= u) ++cell;
  const float within = (u - cdf_[cell]) / (cdf_[cell + 1] - cdf_[cell]);
  const float x = (cell + within) * (radius_ / kTableSize);
  if (settings_.kind == FilterKind::Gaussian) return {side * x, 1};
  return {side * x, std::copysign(absolute_integral_, eval_axis(x))};
}

Filter::Sample Filter::sample(Vec2 u) const {
  const Axis x = sample_axis(u.x);
  const Axis y = sample_axis(u.y);
  return {{x.offset, y.offset}, x.weight * y.weight};
}

Filter::PixelChoice Filter::choose_pixel(float x, float u) const {
  const int first = static_cast<int>(std::ceil(x - radius_ - 0.5f));
  const int last = static_cast<int>(std::floor(x + radius_ - 0.5f));
  const auto value = [&](int i) { return eval_axis(x - (static_cast<float>(i) + 0.5f)); };
  float total = 0;
  for (int i = first; i <= last; ++i) total += std::abs(value(i));
  float rest = u * total;
  int chosen = first;
  float at_chosen = value(chosen);
  while (chosen < last) {
    rest -= std::abs(at_chosen);
    if (rest < 0) break;
    at_chosen = value(++chosen);
  }
  return {chosen, std::copysign(total, at_chosen)};
}

}  // namespace guidelight

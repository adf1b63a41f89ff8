#pragma once

#include <array>

#include "renderer/image/film.h"
#include "renderer/sampling/random.h"
#include "renderer/transport/path.h"

namespace guidelight {

/// Takes the states of a chain to the film, some at a time.
class FilmObserver {
 public:
  /// `scale`: B, what the chain's target integrates to. `rng` is for the pixel filter.
  FilmObserver(Film& film, double scale, Rng rng) : film_(film), scale_(scale), rng_(rng) {}

  void operator()(const Path& path, double weight);
  /// To be called at the end.
  void flush();

 private:
  static constexpr size_t kBatch = 64;

  Film& film_;
  double scale_;
  Rng rng_;
  std::array<Splat, kBatch> splats_;
  std::array<Vec2, kBatch> offsets_;
  size_t count_ = 0;
};

/// L S⁺ D S* E, D being whatever is not specular.
bool is_caustic(const Path& path);

}  // namespace guidelight

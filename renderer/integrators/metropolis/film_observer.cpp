#include "renderer/integrators/metropolis/film_observer.h"

namespace guidelight {

bool is_caustic(const Path& path) {
  if (path.length() < 3 || path.is_finite(1)) return false;
  int finite = 0;
  for (int i = 1; i < path.length(); ++i) finite += path.is_finite(i) ? 1 : 0;
  return finite == 1;
}

Splat splat_of(const Path& path) {
  // f/Y(f) is a colour of luminance 1: f alone may leave the range of single precision.
  return {path.raster, Color(path.contribution() / path.target()), path.length() <= 2,
          is_caustic(path)};
}

void FilmObserver::operator()(const Path& path, double weight) {
  const double pdf = share_.paths > 0 ? sampler_.density(path) : 0;
  add(splat_of(path), weight * share_.luminance(path.target(), pdf));
}

void FilmObserver::add(Splat splat, double weight) {
  splat.contribution *= static_cast<float>(weight);
  splats_[count_] = splat;
  offsets_[count_] = rng_.next_vec2();
  if (++count_ == kBatch) flush();
}

void FilmObserver::flush() {
  film_.add_splats({splats_.data(), count_}, {offsets_.data(), count_});
  count_ = 0;
}

}  // namespace guidelight

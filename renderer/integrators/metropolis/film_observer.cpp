#include "renderer/integrators/metropolis/film_observer.h"

namespace guidelight {

bool is_caustic(const Path& path) {
  if (path.length() < 3 || path.is_finite(1)) return false;
  int finite = 0;
  for (int i = 1; i < path.length(); ++i) finite += path.is_finite(i) ? 1 : 0;
  return finite == 1;
}

void FilmObserver::operator()(const Path& path, double weight) {
  // f/Y(f) is a colour of luminance 1.
  const Color contribution(path.contribution() * (scale_ * weight / path.target()));
  splats_[count_] = {path.raster, contribution, path.length() <= 2, is_caustic(path)};
  offsets_[count_] = rng_.next_vec2();
  if (++count_ == kBatch) flush();
}

void FilmObserver::flush() {
  film_.add_splats({splats_.data(), count_}, {offsets_.data(), count_});
  count_ = 0;
}

}  // namespace guidelight

#include "renderer/metropolis/bidirectional_sampler.h"

#include <cmath>

#include "renderer/transport/path_growth.h"

namespace guidelight {

bool BidirectionalSampler::Gap::is_possible() const {
  const bool sides = from_light != 1 && from_eye != 1;
  const int ends = (from_light == 0 ? 1 : 0) + (from_eye == 0 ? 1 : 0);
  return sides && inserted >= ends && from_light >= 0 && from_eye >= 0;
}

int BidirectionalSampler::technique_count(const Gap& gap) {
  // The lens is never found by chance.
  return gap.from_eye == 0 ? gap.inserted : gap.inserted + 1;
}

template <typename Random>
bool BidirectionalSampler::fill(const Gap& gap, Path& y, Random& rng) const {
  const auto techniques = static_cast<float>(technique_count(gap));
  const int from_light = static_cast<int>(rng.next_float() * techniques);
  const int s = gap.from_light + from_light;  // vertices on the light's side
  if (!grow_from_light(gap, from_light, y, rng)) return false;
  if (!grow_from_eye(gap, gap.inserted - from_light, y, rng)) return false;
  if (s > 0 && (y.length() == 1 || !join(y, s - 1))) return false;
  if (!y.update(scene_, gap.from_light, gap.from_light + gap.inserted - 1)) return false;
  return s == 0 || is_visible(scene_, y, s - 1);
}

template <typename Random>
bool BidirectionalSampler::grow_from_light(const Gap& gap, int count, Path& y, Random& rng) const {
  int i = gap.from_light;
  const int end = gap.from_light + count;
  if (i == 0 && i < end) {
    Ray ray;
    if (!sample_light(scene_, y, rng, ray)) return false;
    if (++i < end && !arrive_from_light(scene_, y, i++, ray)) return false;
  }
  for (; i < end; ++i) {
    if (!scatter_to_eye(scene_, y, i - 1, direction_to_light(y, i - 1), rng)) return false;
  }
  return true;
}

template <typename Random>
bool BidirectionalSampler::grow_from_eye(const Gap& gap, int count, Path& y, Random& rng) const {
  int i = y.length() - gap.from_eye;
  const int end = i - count;
  if (gap.from_eye == 0) {
    const Camera& camera = scene_.camera();
    const Vec2 raster = camera.sample_raster(rng.next_vec2());
    const Vec2 u_lens = rng.next_vec2();
    if (count == 1) return connect_to_lens(scene_, y, u_lens);
    Ray ray;
    sample_lens(scene_, y, raster, u_lens, ray);
    --i;
    if (!arrive_from_eye(scene_, y, i, ray, rng.next_float())) return false;
    --i;
  }
  for (; i > end; --i) {
    if (!scatter_to_light(scene_, y, i + 1, direction_to_eye(y, i + 1), rng)) return false;
  }
  return true;
}

double BidirectionalSampler::density(const Gap& gap, const Path& y) const {
  const int techniques = technique_count(gap);
  double sum = 0;
  for (int from_light = 0; from_light < techniques; ++from_light) {
    const int s = gap.from_light + from_light;
    if (!y.is_connectible_edge(s)) continue;
    double pdf = 1;
    for (int i = gap.from_light; i < s; ++i) pdf *= y.pdf_from_light(i);
    for (int i = s; i < gap.from_light + gap.inserted; ++i) pdf *= y.pdf_from_eye(i);
    sum += pdf;
  }
  return sum / techniques;
}

PathSampler::PathSampler(const Scene& scene, const PathLengths& lengths, PathFilter filter)
    : sampler_(scene), lengths_(lengths), filter_(std::move(filter)) {
  // Longer paths carry less.
  constexpr float kDecay = 0.75f;
  std::vector<float> weights;
  for (int k = lengths.min; k <= lengths.max; ++k) {
    weights.push_back(std::pow(kDecay, static_cast<float>(k - lengths.min)));
  }
  distribution_ = DiscreteDistribution(weights);
}

template <typename Random>
double PathSampler::sample(Path& path, Random& rng) const {
  const auto length = distribution_.sample(rng.next_float());
  const BidirectionalSampler::Gap gap{.from_light = 0,
                                      .inserted = lengths_.min + static_cast<int>(length.index) + 1,
                                      .from_eye = 0};
  path.points.resize(gap.inserted);
  if (!sampler_.fill(gap, path, rng) || (filter_ && !filter_(path))) return 0;
  return length.pmf * sampler_.density(gap, path);
}

template bool BidirectionalSampler::fill(const Gap&, Path&, Rng&) const;
template bool BidirectionalSampler::fill(const Gap&, Path&, PrimarySamples&) const;
template double PathSampler::sample(Path&, Rng&) const;
template double PathSampler::sample(Path&, PrimarySamples&) const;

}  // namespace guidelight

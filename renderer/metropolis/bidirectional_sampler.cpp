#include "renderer/metropolis/bidirectional_sampler.h"

#include <array>
#include <cmath>

#include "renderer/scene/bsdf/scattering.h"
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
  const int from_eye = gap.inserted - from_light;
  // What cannot be joined is given up before rays are traced for it.
  if (s > 0 && from_eye == 0 && !may_scatter_finitely(y, s)) return false;
  if (!grow_from_light(gap, from_light, y, rng)) return false;
  if (s > 0 && !may_scatter_finitely(y, s - 1)) return false;
  if (!grow_from_eye(gap, from_eye, y, rng)) return false;
  if (s > 0 && (y.length() == 1 || !join(y, s - 1))) return false;
  if (!y.update(scene_, gap.from_light, gap.from_light + gap.inserted - 1)) return false;
  return s == 0 || is_visible(scene_, y, s - 1);
}

template <typename Random>
bool BidirectionalSampler::grow_from_light(const Gap& gap, int count, Path& y, Random& rng) const {
  int i = gap.from_light;
  const int end = gap.from_light + count;
  if (i == 0 && count > 1 && guides_.mixture && rng.next_float() < guides_.share) {
    return grow_along_guide(count, y, rng);
  }
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
bool BidirectionalSampler::grow_along_guide(int count, Path& y, Random& rng) const {
  const GuideMixture& mixture = *guides_.mixture;
  const uint32_t guide = mixture.choose(rng.next_float());
  y.guide = static_cast<int>(guide);
  const Vec2 u_position = rng.next_vec2();
  const auto start = mixture.start(guide, u_position, rng.next_vec2());
  if (!start) return false;
  start_from(y, *start->light, start->emission);
  if (!arrive_from_light(scene_, y, 1, start->emission.ray)) return false;
  for (int i = 1; i + 1 < count; ++i) {
    const bool found = i < mixture.length(guide)
                           ? follow_guide(guide, i, y, rng)
                           : scatter_to_eye(scene_, y, i, direction_to_light(y, i), rng);
    if (!found) return false;
  }
  return true;
}

template <typename Random>
bool BidirectionalSampler::follow_guide(uint32_t guide, int i, Path& y, Random& rng) const {
  const GuideMixture& mixture = *guides_.mixture;
  PathPoint& x = y.points[i];
  x.event = lobe_of(mixture.event(guide, i));
  Vec3 direction;
  if (x.event == kLobeNone) {
    direction = mixture.sample_direction(guide, i, rng.next_vec2());
  } else {
    const Scattering scattering(x.point, direction_to_light(y, i), TransportMode::Importance);
    const auto event = scattering.specular(x.event);
    if (!event) return false;
    direction = event->wi;
  }
  return arrive_from_light(scene_, y, i + 1, x.point.spawn_ray(direction));
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

class BidirectionalSampler::LightSides {
 public:
  /// From vertex `first` on: those before it are kept.
  LightSides(const FollowedGuides& guides, const Path& y, int first, int most) {
    densities_[0] = 1;
    for (int count = 1; count <= most; ++count) {
      densities_[count] = densities_[count - 1] * y.pdf_from_light(first + count - 1);
    }
    if (first == 0 && guides.mixture) mix(guides, y, most);
  }

  double operator[](int count) const { return densities_[count]; }

 private:
  void mix(const FollowedGuides& guides, const Path& y, int most) {
    for (int count = 2; count <= most; ++count) densities_[count] *= 1 - guides.share;
    const GuideMixture& mixture = *guides.mixture;
    for (uint32_t j = 0; j < mixture.size() && most >= 2; ++j) {
      const PathPoint& x = y.points[0];
      double pdf = guides.share * mixture.weight(j) * x.arrival_eye *
                   mixture.pdf_start(j, *y.light, x.point, y.points[1].point.position, x.direction);
      for (int count = 2; pdf > 0; ++count) {
        densities_[count] += pdf;
        if (count == most) break;
        pdf *= factor(mixture, j, y, count - 1);
      }
    }
  }

  /// Of the vertex after vertex i.
  static double factor(const GuideMixture& mixture, uint32_t guide, const Path& y, int i) {
    const PathPoint& x = y.points[i];
    if (i >= mixture.length(guide)) return y.pdf_from_light(i + 1);
    return mixture.pdf_step(guide, i, {x.direction, path_event(x.event)}) * x.arrival_eye;
  }

  std::array<double, kLongestPath + 2> densities_;  // as many vertices as a path has, or none
};

double BidirectionalSampler::density(const Gap& gap, const Path& y) const {
  const int techniques = technique_count(gap);
  const LightSides light_sides(guides_, y, gap.from_light, techniques - 1);
  double sum = 0;
  for (int from_light = 0; from_light < techniques; ++from_light) {
    const int s = gap.from_light + from_light;
    if (!y.is_connectible_edge(s)) continue;
    double pdf = light_sides[from_light];
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
  const auto chosen = distribution_.sample(rng.next_float());
  const BidirectionalSampler::Gap gap = whole(lengths_.min + static_cast<int>(chosen.index));
  path.points.resize(gap.inserted);
  path.guide = Path::kNoGuide;
  if (!sampler_.fill(gap, path, rng) || (filter_ && !filter_(path))) return 0;
  return chosen.pmf * sampler_.density(gap, path);
}

double PathSampler::density(const Path& path) const {
  return distribution_.pmf(path.length() - lengths_.min) *
         sampler_.density(whole(path.length()), path);
}

template bool BidirectionalSampler::fill(const Gap&, Path&, Rng&) const;
template bool BidirectionalSampler::fill(const Gap&, Path&, PrimarySamples&) const;
template double PathSampler::sample(Path&, Rng&) const;
template double PathSampler::sample(Path&, PrimarySamples&) const;

}  // namespace guidelight

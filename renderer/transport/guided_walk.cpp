#include "renderer/transport/guided_walk.h"

#include "renderer/transport/guided_places.h"

namespace guidelight {

float GuidedEmission::density_ratio(const Light& light, const SurfacePoint& point, Vec3 ray_origin,
                                    Vec3 direction, double pdf) const {
  if (!(pdf > 0)) return 1;
  double sum = 0;
  for (uint32_t j = 0; j < mixture->size(); ++j) {
    sum += mixture->weight(j) * mixture->pdf_start(j, light, point, ray_origin, direction);
  }
  return static_cast<float>(1 - fraction + fraction * sum / pdf);
}

GuidedWalk::Choice GuidedWalk::begin(Rng& rng) {
  candidates_.clear();
  finished_ = 0;
  density_ = 1;
  guide_ = began_with_ = kNoGuide;
  const float u = rng.next_float();
  if (u >= emission_.fraction) return {false, std::nullopt};
  guide_ = began_with_ = emission_.mixture->choose(u / emission_.fraction);
  const Vec2 u_position = rng.next_vec2();
  return {true, emission_.mixture->start(guide_, u_position, rng.next_vec2())};
}

float GuidedWalk::emit(const Light& light, const EmissionSample& emission, double pdf) {
  const GuideMixture& mixture = *emission_.mixture;
  for (uint32_t j = 0; j < mixture.size(); ++j) {
    const double guided =
        mixture.pdf_start(j, light, emission.point, emission.ray.origin, emission.ray.direction);
    if (guided > 0) candidates_.push_back({j, mixture.weight(j) * guided / pdf});
  }
  finish(1);
  density_ = density_ratio();
  return static_cast<float>(density_);
}

std::optional<ScatteringSample> GuidedWalk::sample(int i, const Scattering& scattering,
                                                   Rng& rng) const {
  const GuideMixture& mixture = *emission_.mixture;
  const PathEvent event = mixture.event(guide_, i);
  if (event != PathEvent::Scatter) return scattering.specular(lobe_of(event));
  const Vec3 wi = mixture.sample_direction(guide_, i, rng.next_vec2());
  const BsdfEvaluation bsdf = scattering.evaluate(wi);
  if (!(bsdf.pdf > 0)) return std::nullopt;
  return ScatteringSample{wi, bsdf.value / bsdf.pdf, bsdf.pdf, 1, kLobeGlossy};
}

float GuidedWalk::scatter(int i, const Scattering& scattering, const ScatteringSample& sample,
                          float survival) {
  for (Candidate& candidate : candidates_) {
    candidate.ratio *= step_ratio(candidate.guide, i, scattering, sample, survival);
  }
  std::erase_if(candidates_, [](const Candidate& candidate) { return candidate.ratio == 0; });
  finish(i + 1);
  const double before = density_;
  density_ = density_ratio();
  return static_cast<float>(before / density_);
}

double GuidedWalk::step_ratio(uint32_t guide, int i, const Scattering& scattering,
                              const ScatteringSample& sample, float survival) const {
  const PathEvent event = path_event(sample.is_delta() ? sample.lobe : kLobeNone);
  const double guided = emission_.mixture->pdf_step(guide, i, {sample.wi, event});
  if (guided > 0 && sample.is_delta()) {
    // Mixtures of materials may refract in two directions, of which guides follow one.
    const auto followed = scattering.specular(sample.lobe);
    if (!followed || !(length_squared(followed->wi - sample.wi) < 1e-8f)) return 0;
  }
  return guided / (static_cast<double>(sample.pdf) * survival);
}

void GuidedWalk::left_photon(Vec3 position) const {
  if (!emission_.places || began_with_ == kNoGuide) return;
  emission_.places->note(position, emission_.mixture->index_in_list(began_with_));
}

void GuidedWalk::finish(int i) {
  const GuideMixture& mixture = *emission_.mixture;
  if (guide_ != kNoGuide && mixture.length(guide_) == i) guide_ = kNoGuide;
  std::erase_if(candidates_, [&](const Candidate& candidate) {
    const bool ends = mixture.length(candidate.guide) == i;
    if (ends) finished_ += candidate.ratio;
    return ends;
  });
}

double GuidedWalk::density_ratio() const {
  double sum = finished_;
  for (const Candidate& candidate : candidates_) sum += candidate.ratio;
  return 1 - emission_.fraction + emission_.fraction * sum;
}

}  // namespace guidelight

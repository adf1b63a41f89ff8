#include "renderer/metropolis/guide_proposal.h"

#include <array>

#include "renderer/scene/bsdf/scattering.h"
#include "renderer/transport/path_growth.h"

namespace guidelight {

namespace {

constexpr float kStraightToLens = 0.5f;

/// Vertices of the eye's side that are kept: from the lens to the first finite one, or 0 where the
/// eye sees the light by specular events alone.
int kept_from_eye(const Path& x) {
  const int first = x.next_finite_towards_light(x.length());
  return first > 0 ? x.size() - first : 0;
}

}  // namespace

bool GuideProposal::propose(const Path& x, int max_length, Path& y, Rng& rng) const {
  const uint32_t guide = guides_->choose(rng.next_float());
  const int vertices = guides_->length(guide) + 1;
  const bool to_lens = rng.next_float() < kStraightToLens;
  const int kept = to_lens ? 0 : kept_from_eye(x);
  y.splice(x, 0, to_lens ? vertices + 1 : vertices, kept);
  y.guide = static_cast<int>(guide);
  if ((!to_lens && kept == 0) || y.length() > max_length) return false;
  if (!follow(guide, y, rng)) return false;
  if (to_lens && !connect_to_lens(scene_, y, rng.next_vec2())) return false;
  return join(y, vertices - 1) && y.update(scene_, 0, to_lens ? vertices : vertices - 1) &&
         is_visible(scene_, y, vertices - 1);
}

bool GuideProposal::follow(uint32_t guide, Path& y, Rng& rng) const {
  const Vec2 u_position = rng.next_vec2();
  const auto start = guides_->start(guide, u_position, rng.next_vec2());
  if (!start) return false;
  start_from(y, *start->light, start->emission);
  Ray ray = start->emission.ray;
  for (int i = 1;; ++i) {
    if (!arrive_from_light(scene_, y, i, ray)) return false;
    if (i == guides_->length(guide)) return true;
    PathPoint& x = y.points[i];
    x.event = lobe_of(guides_->event(guide, i));
    Vec3 direction;
    if (x.event == kLobeNone) {
      direction = guides_->sample_direction(guide, i, rng.next_vec2());
    } else {
      const Scattering scattering(x.point, -ray.direction, TransportMode::Importance);
      const auto event = scattering.specular(x.event);
      if (!event) return false;
      direction = event->wi;
    }
    ray = x.point.spawn_ray(direction);
  }
}

double GuideProposal::density(const Path& x, const Path& y) const {
  // As of the bidirectional mutation: what the paths share was kept, nothing more.
  const int k = y.length();
  const int shared = shared_from_eye(x, y);
  if (shared_from_light(x, y) > (y.light->is_delta() ? 1 : 0)) return 0;
  double sum = 0;
  const bool is_seen = k >= 2 && y.is_finite(k - 1);
  if (is_seen && shared <= (scene_.camera().has_pinhole() ? 1 : 0)) {
    sum += kStraightToLens * prefix_pdf(y, k - 1) * y.pdf_from_eye(k);
  }
  const int kept = kept_from_eye(x);
  const int segments = y.size() - kept - 1;
  const bool is_joined = segments >= 1 && kept > 0 && shared == kept && y.is_finite(segments) &&
                         y.is_finite(segments + 1);
  if (is_joined) sum += (1 - kStraightToLens) * prefix_pdf(y, segments);
  return sum;
}

double GuideProposal::prefix_pdf(const Path& y, int segments) const {
  constexpr int kLongest = 64;
  if (segments > kLongest) return 0;
  std::array<GuidedStep, kLongest> steps;
  double to_area = 1;
  for (int i = 0; i < segments; ++i) {
    steps[i] = {y.points[i].direction, path_event(y.points[i].event)};
    to_area *= y.points[i].arrival_eye;
  }
  return to_area * guides_->pdf_prefix(*y.light, y.points[0].point, y.points[1].point.position,
                                       {steps.data(), static_cast<size_t>(segments)});
}

}  // namespace guidelight

#include "renderer/metropolis/caustic_perturbation.h"

#include "renderer/metropolis/perturbation.h"
#include "renderer/transport/path_growth.h"

namespace guidelight {

namespace {

class CausticPerturbation final : public Mutation {
 public:
  explicit CausticPerturbation(const Scene& scene) : scene_(scene) {}

  std::string name() const override { return "caustic"; }

  bool is_suitable(const Path& x) const override {
    return x.length() >= 2 && x.is_finite(x.length() - 1);
  }

  bool propose(const Path& x, Path& y, Rng& rng) const override {
    const int seen = x.length() - 1;
    const int from = x.next_finite_towards_light(seen);
    y.splice(x, x.size(), 0, 0);
    const float offset = offsets(x, from).sample(rng.next_float());
    const Ray ray = move(x, from, offset, rng.next_float());
    if (!follow_to_eye(scene_, y, from, seen, ray)) return false;
    if (!connect_to_lens(scene_, y, rng.next_vec2()) || !join(y, seen)) return false;
    return y.update(scene_, from + 1, y.length()) && is_visible(scene_, y, seen);
  }

  double density(const Path& x, const Path& y) const override {
    if (!same_form(x, y)) return 0;
    const int seen = x.length() - 1;
    const int from = x.next_finite_towards_light(seen);
    return chain_pdf_to_eye(y, from, seen, pdf_move(x, y, from)) * y.pdf_from_eye(y.length());
  }

 private:
  static bool is_shifted(const Path& x, int from) { return from == 0 && x.light->is_infinite(); }

  /// From a tenth of a pixel to a tenth of the picture, as far as the eye sees it: an angle at
  /// vertex `from`, or a distance across the rays of a light at infinity.
  LogUniform offsets(const Path& x, int from) const {
    const int seen = x.length() - 1;
    const float pixel = pixel_angle(scene_, x) * x.points[seen].distance;
    float range = 1;
    if (!is_shifted(x, from)) {
      range = 0;
      for (int i = from; i < seen; ++i) range += x.points[i].distance;
    }
    const float unit = pixel / range;
    const float width = static_cast<float>(scene_.camera().width());
    const float max = std::max(0.1f * width, 0.2f) * unit;
    return {0.1f * unit, is_shifted(x, from) ? max : std::min(max, 0.5f)};
  }

  Ray move(const Path& x, int from, float offset, float u) const {
    const PathPoint& start = x.points[from];
    if (is_shifted(x, from)) {
      const Frame frame = Frame::from_normal(start.direction);
      const float phi = 2 * kPi * u;
      const Vec3 across = frame.to_world({offset * std::cos(phi), offset * std::sin(phi), 0});
      const Bounds bounds = scene_.bounds();
      const float back = 2 * bounds.radius() +
                         glm::dot(x.points[1].point.position - bounds.center(), start.direction);
      return {x.points[1].point.position + across - back * start.direction, start.direction};
    }
    const Vec3 direction = deflect(start.direction, offset, u);
    return start.point.spawn_ray(direction);
  }

  /// Per solid angle, or per area across the rays.
  double pdf_move(const Path& x, const Path& y, int from) const {
    const LogUniform distribution = offsets(x, from);
    if (!is_shifted(x, from)) {
      const float angle = angle_between(x.points[from].direction, y.points[from].direction);
      return deflection_pdf(distribution.pdf(angle), angle);
    }
    const Vec3 shift = y.points[1].point.position - x.points[1].point.position;
    const Vec3 direction = x.points[0].direction;
    const float offset = glm::length(shift - direction * glm::dot(shift, direction));
    return distribution.pdf(offset) / (2 * kPi * offset);
  }

  const Scene& scene_;
};

}  // namespace

std::unique_ptr<Mutation> make_caustic_perturbation(const Scene& scene) {
  return std::make_unique<CausticPerturbation>(scene);
}

}  // namespace guidelight

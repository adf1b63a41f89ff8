#include "renderer/metropolis/eye_perturbations.h"

#include "renderer/metropolis/perturbation.h"
#include "renderer/transport/path_growth.h"

namespace guidelight {

namespace {

/// Offsets in the picture: from a tenth of a pixel to the radius of a disc of 5 % of its area.
LogUniform raster_offsets(const Camera& camera) {
  const float pixels = static_cast<float>(camera.width()) * static_cast<float>(camera.height());
  return {0.1f, std::max(std::sqrt(0.05f * pixels * kInvPi), 0.2f)};
}

/// Whether the vertices behind a chain from the eye that ends at `end` can be kept: they are joined
/// there, or there are none.
bool can_end_at(const Path& path, int end) { return end == 0 || path.is_finite(end - 1); }

/// Completes a path whose vertices from `end` on towards the eye are new, up to `last`.
bool finish(const Scene& scene, Path& y, int end, int last) {
  if (end > 0 && !join(y, end - 1)) return false;
  return y.update(scene, end, last) && (end == 0 || is_visible(scene, y, end - 1));
}

/// Common to the lens and the multi-chain perturbation: the chain from the lens.
class PicturePerturbation : public Mutation {
 public:
  explicit PicturePerturbation(const Scene& scene)
      : scene_(scene), offsets_(raster_offsets(scene.camera())) {}

 protected:
  /// Moves the place in the picture and follows to vertex `to`.
  bool move(const Path& x, Path& y, int to, Rng& rng) const {
    const float radius = offsets_.sample(rng.next_float());
    const float phi = 2 * kPi * rng.next_float();
    const Vec2 raster = x.raster + radius * Vec2(std::cos(phi), std::sin(phi));
    const Camera& camera = scene_.camera();
    if (!camera.is_seen(raster)) return false;
    Ray ray;
    sample_lens(scene_, y, raster, rng.next_vec2(), ray);
    return follow_to_light(scene_, y, y.length(), to, ray, rng.next_float());
  }

  double pdf_move(const Path& x, const Path& y, int to) const {
    const float distance = glm::length(y.raster - x.raster);
    const float pdf_raster = offsets_.pdf(distance) / (2 * kPi * distance);
    // Uniform over the raster is what the path's density means.
    const Camera& camera = scene_.camera();
    const double pdf_direction = double{pdf_raster} * camera.raster_excess() * camera.width() *
                                 camera.height() * y.lens().pdf_to_light;
    return y.pdf_from_eye(y.length()) * chain_pdf_to_light(y, y.length(), to, pdf_direction);
  }

  const Scene& scene_;

 private:
  LogUniform offsets_;
};

class LensPerturbation final : public PicturePerturbation {
 public:
  using PicturePerturbation::PicturePerturbation;
  std::string name() const override { return "lens"; }

  bool is_suitable(const Path& x) const override {
    return can_end_at(x, x.next_finite_towards_light(x.length()));
  }

  bool propose(const Path& x, Path& y, Rng& rng) const override {
    const int end = x.next_finite_towards_light(x.length());
    y.splice(x, x.size(), 0, 0);
    return move(x, y, end, rng) && finish(scene_, y, end, y.length());
  }

  double density(const Path& x, const Path& y) const override {
    if (!same_form(x, y)) return 0;
    const int end = x.next_finite_towards_light(x.length());
    return pdf_move(x, y, end);
  }
};

class MultiChainPerturbation final : public PicturePerturbation {
 public:
  using PicturePerturbation::PicturePerturbation;
  std::string name() const override { return "multi_chain"; }

  bool is_suitable(const Path& x) const override {
    return !can_end_at(x, x.next_finite_towards_light(x.length()));
  }

  bool propose(const Path& x, Path& y, Rng& rng) const override {
    int end = x.next_finite_towards_light(x.length());
    y.splice(x, x.size(), 0, 0);
    if (!move(x, y, end, rng)) return false;
    while (!can_end_at(x, end)) {
      const int from = end;
      end = x.next_finite_towards_light(from);
      const float angle = kAngles.sample(rng.next_float());
      const Vec3 direction = deflect(-x.points[from - 1].direction, angle, rng.next_float());
      const Ray ray = y.points[from].point.spawn_ray(direction);
      if (!follow_to_light(scene_, y, from, end, ray, rng.next_float())) return false;
    }
    return finish(scene_, y, end, y.length());
  }

  double density(const Path& x, const Path& y) const override {
    if (!same_form(x, y)) return 0;
    int end = x.next_finite_towards_light(x.length());
    double pdf = pdf_move(x, y, end);
    while (!can_end_at(x, end) && pdf > 0) {
      const int from = end;
      end = x.next_finite_towards_light(from);
      const float angle = angle_between(x.points[from - 1].direction, y.points[from - 1].direction);
      pdf *= chain_pdf_to_light(y, from, end, deflection_pdf(kAngles.pdf(angle), angle));
    }
    return pdf;
  }

 private:
  static inline const LogUniform kAngles{1e-4f, 0.1f};  // [rad]
};

class PhotonMapPerturbation final : public Mutation {
 public:
  PhotonMapPerturbation(const Scene& scene, float max_angle)
      : scene_(scene), max_angle_(max_angle) {}

  std::string name() const override { return "photon_map"; }

  bool is_suitable(const Path& x) const override {
    const int from = x.next_finite_towards_light(x.length());
    return from > 0 && can_end_at(x, x.next_finite_towards_light(from));
  }

  bool propose(const Path& x, Path& y, Rng& rng) const override {
    const int from = x.next_finite_towards_light(x.length());
    const int end = x.next_finite_towards_light(from);
    y.splice(x, x.size(), 0, 0);
    const float angle = max_angle_ * rng.next_float();
    const Vec3 direction = deflect(-x.points[from - 1].direction, angle, rng.next_float());
    const Ray ray = x.points[from].point.spawn_ray(direction);
    return follow_to_light(scene_, y, from, end, ray, rng.next_float()) &&
           finish(scene_, y, end, from - 1);
  }

  double density(const Path& x, const Path& y) const override {
    if (!same_form(x, y)) return 0;
    const int from = x.next_finite_towards_light(x.length());
    const int end = x.next_finite_towards_light(from);
    const float angle = angle_between(x.points[from - 1].direction, y.points[from - 1].direction);
    if (angle > max_angle_) return 0;
    return chain_pdf_to_light(y, from, end, deflection_pdf(1 / max_angle_, angle));
  }

 private:
  const Scene& scene_;
  float max_angle_;
};

}  // namespace

std::unique_ptr<Mutation> make_lens_perturbation(const Scene& scene) {
  return std::make_unique<LensPerturbation>(scene);
}
std::unique_ptr<Mutation> make_multi_chain_perturbation(const Scene& scene) {
  return std::make_unique<MultiChainPerturbation>(scene);
}
std::unique_ptr<Mutation> make_photon_map_perturbation(const Scene& scene, float max_angle) {
  return std::make_unique<PhotonMapPerturbation>(scene, max_angle);
}

}  // namespace guidelight

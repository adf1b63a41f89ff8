#include "renderer/metropolis/lens_subpath_mutation.h"

#include "renderer/scene/bsdf/scattering.h"
#include "renderer/transport/path_growth.h"

namespace guidelight {

namespace {

/// The probability that a path from the eye does not go on by a delta event at a vertex.
float stop_probability(const SurfacePoint& point, Vec3 to_eye) {
  if (!(point.bsdf->lobes() & kLobeDelta)) return 1;
  const Scattering scattering(point, to_eye, TransportMode::Radiance);
  float stop = 1;
  for (const Lobe lobe : {kLobeDeltaReflection, kLobeDeltaTransmission}) {
    if (const auto event = scattering.specular(lobe)) stop -= event->pdf;
  }
  return std::max(stop, 0.0f);
}

class LensSubpathMutation final : public Mutation {
 public:
  LensSubpathMutation(const Scene& scene, const PathLengths& lengths)
      : scene_(scene), lengths_(lengths) {}

  std::string name() const override { return "lens_subpath"; }

  bool is_suitable(const Path& x) const override {
    const int end = x.next_finite_towards_light(x.length());
    return end > 0 && x.is_finite(end - 1);
  }

  bool propose(const Path& x, Path& y, Rng& rng) const override {
    const int kept = x.next_finite_towards_light(x.length());
    // Grown from the far end of the longest path, then moved to where it belongs.
    const int longest = lengths_.max + 1;
    y.splice(x, kept, longest - kept, 0);
    const int first = grow(y, kept, rng);
    if (first < kept) return false;
    y.points.erase(y.points.begin() + kept, y.points.begin() + first);
    if (!lengths_.contains(y.length())) return false;
    return join(y, kept - 1) && y.update(scene_, kept, y.length()) &&
           is_visible(scene_, y, kept - 1);
  }

  double density(const Path& x, const Path& y) const override {
    const int kept = x.next_finite_towards_light(x.length());
    if (y.next_finite_towards_light(y.length()) != kept) return 0;
    double pdf = 1;
    for (int i = kept; i < y.size(); ++i) pdf *= y.pdf_from_eye(i);
    return pdf * stop_probability(y.points[kept].point, y.points[kept].direction);
  }

 private:
  /// A new path from the eye to the first vertex where it is not continued by a delta event: the
  /// index of that vertex, or -1.
  int grow(Path& y, int lowest, Rng& rng) const {
    const Camera& camera = scene_.camera();
    const Vec2 raster = camera.sample_raster(rng.next_vec2());
    Ray ray;
    sample_lens(scene_, y, raster, rng.next_vec2(), ray);
    for (int i = y.length() - 1; i >= lowest; --i) {
      if (i == 0 || !arrive_from_eye(scene_, y, i, ray, 0)) return -1;
      PathPoint& x = y.points[i];
      if (!(x.point.bsdf->lobes() & kLobeDelta)) return i;
      const float u_lobe = rng.next_float();
      const auto sample = Scattering(x.point, -ray.direction, TransportMode::Radiance)
                              .sample(u_lobe, rng.next_vec2());
      if (!sample || !sample->is_delta()) return x.point.bsdf->lobes() & kLobeSmooth ? i : -1;
      x.event = sample->lobe;
      ray = x.point.spawn_ray(sample->wi);
    }
    return -1;
  }

  const Scene& scene_;
  PathLengths lengths_;
};

}  // namespace

std::unique_ptr<Mutation> make_lens_subpath_mutation(const Scene& scene,
                                                     const PathLengths& lengths) {
  return std::make_unique<LensSubpathMutation>(scene, lengths);
}

}  // namespace guidelight

#include "renderer/integrators/photon_mapping/importance.h"

#include <algorithm>

#include "renderer/integrators/photon_mapping/second_pass.h"
#include "renderer/transport/connect.h"

namespace guidelight {

namespace {

constexpr uint64_t kImportanceStream = 0x696d706f7274ull;

/// A pinhole sees a place along one line; through a lens it takes an integral.
bool sees_along_lines(const Camera& camera) { return camera.has_pinhole(); }

/// Paths from the lens that leave importons at their first and second diffuse events.
class EyeWalk {
 public:
  EyeWalk(const PhotonMappingPass& setup, size_t count)
      : setup_(setup), count_(count), walk_(setup.scene, TransportMode::Radiance) {}

  /// Traces paths [first, last).
  PassPhotons trace(size_t first, size_t last) {
    const Camera& camera = setup_.scene.camera();
    std::vector<Subpath> paths;
    for (size_t i = first; i < last; ++i) {
      Rng rng(setup_.seed ^ kImportanceStream, setup_.pass, i);
      const Vec2 raster = camera.sample_raster(rng.next_vec2());
      paths.push_back(start_camera_path(setup_.scene, raster, rng));
    }
    diffuse_events_.assign(paths.size(), 0);
    walk_.run(paths, *this);
    return std::move(particles_);
  }

  // RandomWalk's visitor.
  void escaped(uint32_t, Subpath&) {}
  bool visit(uint32_t index, Subpath& path, const PathVertex& vertex, const Scattering&) {
    uint8_t& events = diffuse_events_[index];
    if (path.length > 0 && !setup_.global.sharp.at_origin(path)) ++events;
    if (events > 1) return false;
    const bool is_new =
        events == 1 || vertex.length > 1 || !sees_along_lines(setup_.scene.camera());
    if (vertex.is_connectible() && is_new) {
      const float excess = setup_.scene.camera().raster_excess();
      const Color weight = vertex.throughput * excess / static_cast<float>(count_);
      auto& particles = events == 1 ? particles_.global : particles_.caustic;
      particles.push_back(make_surface_photon(vertex, weight, false));
    }
    return vertex.length + 1 < setup_.global.max_length;
  }
  void end_segment() {}

 private:
  const PhotonMappingPass& setup_;
  size_t count_;
  RandomWalk walk_;
  std::vector<uint8_t> diffuse_events_;  // of each path so far
  PassPhotons particles_;
};

}  // namespace

ImportanceMaps::ImportanceMaps(const PhotonMappingPass& setup, const Settings& settings,
                               Parallel& parallel)
    : scene_(setup.scene), estimate_(setup.global) {
  estimate_.neighbors = settings.neighbors;
  // Farther than photons are looked for nothing needs to be known: light paths alone leave photons
  // there, and the search for k neighbours is quick where hardly any particles are.
  estimate_.kernel = Kernel::Constant;
  estimate_.oversearch = 4;
  // The weights of chains and light paths divide by an estimate, and must not by a guess.
  estimate_.min_effective = 0.2f * static_cast<float>(settings.neighbors);
  constexpr size_t kPathsPerTask = 1024;
  std::vector<PassPhotons> parts((settings.paths + kPathsPerTask - 1) / kPathsPerTask);
  parallel.for_each(parts.size(), [&](size_t task) {
    parts[task] =
        EyeWalk(setup, settings.paths)
            .trace(task * kPathsPerTask, std::min(settings.paths, (task + 1) * kPathsPerTask));
  });
  const PassPhotons all = join(parts);
  global_ = PhotonMap(all.global, parallel);
  caustic_ = PhotonMap(all.caustic, parallel);
}

Color ImportanceMaps::estimate(const PhotonMap& map, const PathVertex& vertex,
                               const Scattering& scattering) const {
  // Of k neighbours the density (k-1)/πr² is unbiased, and the reciprocal of k/πr².
  const auto k = static_cast<float>(estimate_.neighbors);
  return map.radiance(vertex, scattering, estimate_) * (k / (k - 1));
}

Color ImportanceMaps::of_global(const PathVertex& vertex, const Scattering& scattering) const {
  return estimate(global_, vertex, scattering);
}

Color ImportanceMaps::of_caustic(const PathVertex& vertex, const Scattering& scattering) const {
  const Color mirrored = estimate(caustic_, vertex, scattering);
  return sees_along_lines(scene_.camera()) ? mirrored + seen_directly(vertex, scattering)
                                           : mirrored;
}

Color ImportanceMaps::seen_directly(const PathVertex& vertex, const Scattering& scattering) const {
  PathVertex unit = vertex;
  unit.throughput = Color(1);
  const auto connection = connect_to_lens(scene_.camera(), unit, scattering, Vec2(0.5f));
  if (!connection) return Color(0);
  // Sharp events are not among those that leave photons.
  const Vec3 to_lens = connection->shadow_ray.direction;
  const bool counts = !estimate_.sharp(vertex, scattering, to_lens);
  return counts && !scene_.occluded(connection->shadow_ray) ? connection->contribution : Color(0);
}

}  // namespace guidelight

#pragma once

#include <span>
#include <vector>

#include "renderer/scene/bsdf/scattering.h"
#include "renderer/transport/path_vertex.h"
#include "renderer/transport/subpath.h"

namespace guidelight {

/// The random walk of every bidirectional and photon method: advances a batch of subpaths together,
/// segment by segment, so that their rays are traced in packets. Sampling follows the BSDF; Russian
/// roulette uses the albedo alone, which makes the survival probability the same from both ends of
/// a path. Light paths may follow guides instead. One object serves many batches and keeps its
/// memory.
///
/// A Visitor has
///   void escaped(uint32_t index, Subpath& path)          the segment left the scene
///   bool visit(uint32_t index, Subpath& path, const PathVertex& vertex,
///              const Scattering& scattering)             false ends the path here
///   void end_segment()                                   all paths of the batch have been visited
/// where `index` is the path's in the batch; path.rng may be drawn from. It may have, too,
///   void expect(Vec3 position, bool soon)
/// which is called twice before a visit, some and few visits ahead, so that what it will read can
/// be fetched.
class RandomWalk {
 public:
  /// `weights` must outlive this. Without them, vertices and paths carry no partial sums, which
  /// saves their computation where no other technique is weighted against.
  RandomWalk(const Scene& scene, TransportMode mode, const MisWeights* weights = nullptr)
      : scene_(scene), mode_(mode), weights_(weights) {}

  template <typename Visitor>
  void run(std::span<Subpath> paths, Visitor& visitor);

 private:
  /// Calls visitor.expect, if there is one, for paths that come after the i-th of the active ones.
  template <typename Visitor>
  void announce(size_t i, size_t count, Visitor& visitor) const;
  /// The vertex at the end of the segment.
  PathVertex arrive(const Subpath& path, const Hit& hit) const;
  /// The sums at the origin of the segment that leaves a vertex.
  void close_sums(Subpath& path, const PathVertex& vertex, const ScatteringSample& sample) const;
  /// How the path goes on from the vertex; empty if it ends.
  std::optional<ScatteringSample> draw(Subpath& path, const PathVertex& vertex,
                                       const Scattering& scattering) const;
  /// Replaces the segment by the next one. False if the path ends.
  bool scatter(Subpath& path, const PathVertex& vertex, const Scattering& scattering) const;

  const Scene& scene_;
  TransportMode mode_;
  const MisWeights* weights_;
  std::vector<uint32_t> active_;
  std::vector<Ray> rays_;
  std::vector<Hit> hits_;
};

/// The balance heuristic's partial sums where a camera path escapes to a light at infinity: the
/// direction stands for the vertex on the light, measured per solid angle.
struct EscapePartials {
  MisPartials partials;
  float merging_before_last;  // see PathVertex
};
EscapePartials escape_partials(const Subpath& path);

/// Probability that a walk goes on from a point: what the surface reflects at most.
float survival_probability(const SurfacePoint& point);

template <typename Visitor>
void RandomWalk::announce(size_t i, size_t count, Visitor& visitor) const {
  if constexpr (requires { visitor.expect(Vec3(), true); }) {
    for (const size_t ahead : {16, 8}) {
      const size_t next = i + ahead;
      if (next >= count || !hits_[next].valid()) continue;
      visitor.expect(rays_[next].origin + hits_[next].t * rays_[next].direction, ahead == 8);
    }
  }
}

template <typename Visitor>
void RandomWalk::run(std::span<Subpath> paths, Visitor& visitor) {
  active_.resize(paths.size());
  rays_.resize(paths.size());
  hits_.resize(paths.size());
  for (uint32_t i = 0; i < paths.size(); ++i) active_[i] = i, rays_[i] = paths[i].ray;
  size_t count = paths.size();
  while (count > 0) {
    scene_.intersect({rays_.data(), count}, {hits_.data(), count});
    size_t survivors = 0;
    for (size_t i = 0; i < count; ++i) {
      announce(i, count, visitor);
      const uint32_t index = active_[i];
      Subpath& path = paths[index];
      if (!hits_[i].valid()) {
        if (path.medium) path.throughput *= path.medium->transmittance(kInfinity);
        visitor.escaped(index, path);
        continue;
      }
      const PathVertex vertex = arrive(path, hits_[i]);
      const Scattering scattering(vertex.point, vertex.wo, mode_);
      if (!visitor.visit(index, path, vertex, scattering)) continue;
      if (!scatter(path, vertex, scattering)) continue;
      active_[survivors] = index;
      rays_[survivors++] = path.ray;
    }
    count = survivors;
    visitor.end_segment();
  }
}

}  // namespace guidelight

#include "renderer/photons/photon_tracer.h"

#include "renderer/parallel/concatenate.h"
#include "renderer/parallel/object_pool.h"
#include "renderer/transport/light_path_batch.h"

namespace guidelight {

namespace {

/// Light paths draw other random numbers than the camera path of the same number.
constexpr uint64_t kPhotonStream = 0x70686f746f6eull;

/// Paths that are traced together: enough for full packets, few enough to stop soon.
constexpr size_t kBatch = 512;

/// RandomWalk's visitor.
struct PhotonCollector {
  std::vector<Photon>& photons;
  int max_length;

  void escaped(uint32_t, Subpath&) {}
  bool visit(uint32_t, Subpath& path, const PathVertex& vertex, const Scattering& scattering) {
    const Color power = shaded_power(vertex, scattering);
    if (scattering.is_connectible() && !is_black(power)) {
      photons.push_back(
          make_photon(vertex.point.position, vertex.wo, power, vertex.length, vertex.is_caustic()));
      if (path.guided) path.guided->left_photon(vertex.point.position);
    }
    return vertex.length < max_length;
  }
  void end_segment() {}
};

/// Traces batches of a range of paths, one after the other.
class BatchTracer {
 public:
  BatchTracer(const Scene& scene, const LightPathRange& range)
      : range_(range), batch_(scene, 1, range.guided), walk_(scene, TransportMode::Importance) {}

  /// Paths [first, last).
  void trace(size_t first, size_t last, std::vector<Photon>& photons) {
    batch_.reset(last - first);
    for (size_t i = first; i < last; ++i) {
      batch_.add(Rng(range_.seed ^ kPhotonStream, range_.pass, i));
    }
    photons.clear();
    PhotonCollector collector{photons, range_.max_length};
    walk_.run(batch_.paths(), collector);
  }

 private:
  const LightPathRange& range_;
  LightPathBatch batch_;
  RandomWalk walk_;
};

}  // namespace

const std::vector<Photon>& PhotonTracer::trace(const Scene& scene, const LightPathRange& paths,
                                               Parallel& parallel) {
  const bool is_dark = scene.lights().empty() || paths.max_length < 1;
  const size_t count = is_dark ? 0 : (paths.count + kBatch - 1) / kBatch;
  batches_.resize(count);
  ObjectPool<BatchTracer> tracers([&] { return std::make_unique<BatchTracer>(scene, paths); });
  parallel.for_each(count, [&](size_t batch) {
    const size_t first = batch * kBatch;
    tracers.with([&](BatchTracer& tracer) {
      tracer.trace(first, std::min(first + kBatch, paths.count), batches_[batch]);
    });
  });
  concatenate(batches_, photons_, parallel);
  return photons_;
}

size_t PhotonTracer::bytes() const {
  size_t sum = photons_.capacity() * sizeof(Photon);
  for (const auto& batch : batches_) sum += batch.capacity() * sizeof(Photon);
  return sum;
}

}  // namespace guidelight

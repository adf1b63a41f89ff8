#include "bench/ray_replay.h"

#include <benchmark/benchmark.h>

namespace guidelight {

RayCounts count_rays(const RayLog& log) {
  RayCounts counts;
  for (const auto& batch : log.batches()) {
    (batch.shadow ? counts.shadow : counts.closest) += batch.rays.size();
  }
  return counts;
}

namespace {

/// What a ray query writes; kept from batch to batch.
struct Answers {
  std::vector<Hit> hits;
  std::vector<uint8_t> blocked;

  explicit Answers(size_t size) : hits(size), blocked(size) {}
};

void replay(const RayLog::Batch& batch, const Scene& scene, Answers& answers) {
  const auto& rays = batch.rays;
  if (batch.in_packets && batch.shadow) {
    scene.occluded(rays, {answers.blocked.data(), rays.size()});
  } else if (batch.in_packets) {
    scene.intersect(rays, {answers.hits.data(), rays.size()});
  } else if (batch.shadow) {
    for (size_t i = 0; i < rays.size(); ++i) answers.blocked[i] = scene.occluded(rays[i]);
  } else {
    for (size_t i = 0; i < rays.size(); ++i) answers.hits[i] = scene.intersect(rays[i]);
  }
}

}  // namespace

void trace_again(const RayLog& log, const Scene& scene, Parallel& parallel) {
  const auto& batches = log.batches();
  size_t largest = 0;
  for (const auto& batch : batches) largest = std::max(largest, batch.rays.size());
  constexpr size_t kChunk = 64;
  parallel.for_each((batches.size() + kChunk - 1) / kChunk, [&](size_t chunk) {
    Answers answers(largest);
    for (size_t i = chunk * kChunk; i < std::min(batches.size(), (chunk + 1) * kChunk); ++i) {
      replay(batches[i], scene, answers);
    }
    benchmark::DoNotOptimize(answers);
  });
}

}  // namespace guidelight

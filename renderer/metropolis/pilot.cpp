#include "renderer/metropolis/pilot.h"

#include <cmath>

#include "renderer/metropolis/guided_chains.h"
#include "renderer/metropolis/seeding.h"
#include "renderer/metropolis/ways.h"
#include "renderer/transport/guide_check.h"

namespace guidelight {

namespace {

constexpr PathLengths kLengths{3, 12};
constexpr size_t kSeedPaths = 40000;
constexpr size_t kChains = 32;
constexpr MutationWeights kWeights{.bidirectional = 0.3f,
                                   .lens = 0.2f,
                                   .caustic = 0.15f,
                                   .multi_chain = 0.15f,
                                   .lens_subpath = 0.2f};

}  // namespace

std::vector<HarvestedPath> pilot_guides(const Scene& scene, uint64_t mutations, size_t count,
                                        const std::atomic<bool>& stop) {
  Parallel parallel(1);
  Seeding seeding(scene, kLengths);
  if (!stop) seeding.draw(kSeedPaths, 0, 0, parallel);
  Ways ways(scene);
  if (!seeding.can_start()) return {};
  const GuidedChains chains(scene, kLengths, kWeights);
  for (size_t i = 0; i < kChains && !stop; ++i) {
    Rng rng(1, 0, i);
    MarkovChain chain(chains.mutations(), seeding.start_path(i, kChains), Rng(2, 0, i));
    chain.run(std::max<uint64_t>(1, mutations / kChains), [&](const Path& path, double weight) {
      // The largest of u^(1/w) is one drawn in proportion to w (Efraimidis & Spirakis 2006).
      ways.add(path, weight, std::log(1 - rng.next_float()) / weight);
    });
  }
  auto found = ways.strongest(SIZE_MAX);
  std::erase_if(found,
                [&](const HarvestedPath& path) { return !check_guide(scene, path.guide).empty(); });
  if (found.size() > count) found.resize(count);
  return found;
}

}  // namespace guidelight

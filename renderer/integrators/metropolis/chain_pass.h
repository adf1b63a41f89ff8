#pragma once

#include "renderer/integrators/integrator.h"
#include "renderer/integrators/metropolis/film_observer.h"
#include "renderer/metropolis/seeding.h"

namespace guidelight {

/// Settings of every method whose chains paint the picture.
struct ChainSettings : IntegratorSettings {
  int max_length = 12;
  int min_length = 1;
  bool separate_direct = true;
  float mutations = 4;  // per pixel and pass
  int chains = 64;
  int seed_paths = 40000;  // per pass

  explicit ChainSettings(const RenderHints& hints);
  std::vector<Parameter> parameters() override;
};

/// What every pass of such a method does: direct light by the path tracer, independent paths for
/// the picture's brightness, and steps of chains, which live on from pass to pass. A render that is
/// resumed starts new chains.
class ChainPass {
 public:
  /// `settings` must outlive this.
  ChainPass(std::shared_ptr<const Scene> scene, const ChainSettings& settings);

  /// The paths that are left to the chains.
  const PathLengths& lengths() const { return lengths_; }
  const Seeding& seeding() const { return seeding_; }

  /// `start(path_rng, chain_rng)` makes a chain that begins with the path that seeding().sampler()
  /// draws with `path_rng`. Chain has run(steps, observe).
  template <typename Chain, typename Start>
  void render(uint32_t pass, Film& film, const PassContext& context, std::vector<Chain>& chains,
              Start&& start) {
    if (!prepare(pass, film, context)) return;
    if (chains.empty() && seeding_.normalization() > 0) {
      const size_t count = settings_.chains;
      for (size_t i = 0; i < count; ++i) {
        chains.push_back(start(seeding_.start(i, count), rng(context, Stream::Chain, pass, i)));
      }
    }
    // Where nothing carries light there are no chains, and the picture is black.
    const uint64_t steps = steps_per_chain(film);
    if (chains.empty()) film.add_splat_count(steps * settings_.chains);
    context.parallel->for_each(chains.size(), [&](size_t i) {
      FilmObserver observer(film, seeding_.normalization(), rng(context, Stream::Filter, pass, i));
      chains[i].run(steps, observer);
      observer.flush();
      film.add_splat_count(steps);
    });
  }

 private:
  enum class Stream : uint64_t { Chain = 1, Filter = 2 };
  static Rng rng(const PassContext& context, Stream stream, uint32_t pass, size_t chain) {
    return {context.seed, (static_cast<uint64_t>(stream) << 32) + pass, chain};
  }

  /// Renders direct light and draws seeds; false if nothing is left to the chains.
  bool prepare(uint32_t pass, Film& film, const PassContext& context);
  uint64_t steps_per_chain(const Film& film) const;

  const ChainSettings& settings_;
  PathLengths lengths_;
  Seeding seeding_;
  std::unique_ptr<Integrator> direct_;
};

}  // namespace guidelight

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
  int direct_samples = 4;  // per pixel and pass
  float mutations = 4;     // per pixel and pass
  int chains = 64;
  int seed_paths = 40000;  // per pass

  explicit ChainSettings(const RenderHints& hints);
  std::vector<Parameter> parameters() override;
};

/// What every pass of such a method does: direct light by the path tracer, independent paths, and
/// steps of chains that start from these. In every pass they start anew: where the first paths of
/// all had one that carries far too much, many chains would begin with it and stay.
class ChainPass {
 public:
  /// `settings` must outlive this.
  ChainPass(std::shared_ptr<const Scene> scene, const ChainSettings& settings);

  /// The paths that are left to the chains.
  const PathLengths& lengths() const { return lengths_; }
  const Seeding& seeding() const { return seeding_; }
  Seeding& seeding() { return seeding_; }

  /// `start(i, path_rng, chain_rng)` lets chain i, which may not exist yet, begin with the path
  /// that seeding().sampler() draws with `path_rng`. Chain has run(steps, observe).
  template <typename Chain, typename Start>
  void render(uint32_t pass, Film& film, const PassContext& context, std::vector<Chain>& chains,
              Start&& start) {
    if (!prepare(pass, film, context)) return;
    const size_t count = seeding_.can_start() ? settings_.chains : 0;
    for (size_t i = 0; i < count; ++i) {
      start(i, seeding_.start(i, count), rng(context, Stream::Chain, pass, i));
    }
    // Where nothing carries light no chain starts, and the pass is black.
    const uint64_t steps = steps_per_chain(film);
    if (count == 0) film.add_splat_count(steps * settings_.chains);
    const ChainShare share{.normalization = seeding_.normalization(),
                           .states = static_cast<double>(steps * count),
                           .paths = static_cast<double>(seeds_.size())};
    // Every chain brings its part of the independent paths along: a pass may be given up.
    context.parallel->for_each(count, [&](size_t i) {
      FilmObserver observer(film, share, seeding_.sampler(), rng(context, Stream::Filter, pass, i));
      for (size_t j = i * seeds_.size() / count; j < (i + 1) * seeds_.size() / count; ++j) {
        const Seed& seed = seeds_[j];
        if (seed.pdf > 0) observer.add(seed.splat, share.luminance(seed.target, seed.pdf));
      }
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

  /// An independent path of this pass.
  struct Seed {
    Splat splat;
    double target;
    double pdf = 0;  // 0: it carries nothing
  };

  const ChainSettings& settings_;
  PathLengths lengths_;
  Seeding seeding_;
  std::vector<Seed> seeds_;
  std::unique_ptr<Integrator> direct_;
};

}  // namespace guidelight

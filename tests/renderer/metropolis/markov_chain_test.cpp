// Detailed balance: a chain that starts with a path drawn from its target stays in it. Chains of
// each mutation alone, with the ergodic one, and of all together show the means of the picture's
// blocks that the path tracer shows.

#include "renderer/metropolis/markov_chain.h"

#include <gtest/gtest.h>

#include "renderer/integrators/metropolis/film_observer.h"
#include "renderer/metropolis/bidirectional_mutation.h"
#include "renderer/metropolis/bidirectional_sampler.h"
#include "renderer/metropolis/caustic_perturbation.h"
#include "renderer/metropolis/eye_perturbations.h"
#include "renderer/metropolis/lens_subpath_mutation.h"
#include "renderer/transport/guide_trace.h"
#include "tests/renderer/comparison_scenes.h"
#include "tests/renderer/test_scenes.h"
#include "tests/statistics/hypothesis_tests.h"

namespace guidelight {
namespace {

using statistics::Moments;

constexpr int kChainSide = testing::kComparisonSide;
constexpr int kBlocks = 2;  // in each direction
constexpr PathLengths kChainLengths{1, 6};

using Blocks = std::array<double, kBlocks * kBlocks + 1>;  // the last is the whole picture

Blocks block_means(const Image& picture) {
  Blocks means{};
  for (int y = 0; y < kChainSide; ++y) {
    for (int x = 0; x < kChainSide; ++x) {
      const double value = luminance(picture.color(x, y)) / (kChainSide * kChainSide);
      means[y * kBlocks / kChainSide * kBlocks + x * kBlocks / kChainSide] += value;
      means.back() += value;
    }
  }
  return means;
}

enum Which {
  kBidirectional = 1,
  kLens = 2,
  kMultiChain = 4,
  kCaustic = 8,
  kSubpath = 16,
  kMap = 32
};

MutationSet make_set(const Scene& scene, int which,
                     std::shared_ptr<const GuideMixture> guides = nullptr) {
  MutationSet set;
  set.add(make_bidirectional_mutation(scene, kChainLengths, std::move(guides), 0.5f), 0.3f);
  const auto add = [&](Which bit, std::unique_ptr<Mutation> mutation) {
    if (which & bit) set.add(std::move(mutation), 1);
  };
  add(kLens, make_lens_perturbation(scene));
  add(kMultiChain, make_multi_chain_perturbation(scene));
  add(kCaustic, make_caustic_perturbation(scene));
  add(kSubpath, make_lens_subpath_mutation(scene, kChainLengths));
  add(kMap, make_photon_map_perturbation(scene, kPi / 6));
  return set;
}

/// Means of the blocks by one run: chains from paths that are drawn by what they carry.
Blocks run_chains(const Scene& scene, const MutationSet& set, uint64_t seed, int chains,
                  int steps) {
  constexpr int kSeeds = 40000;
  const PathSampler sampler(scene, kChainLengths);
  std::vector<float> weights(kSeeds);
  double total = 0;
  Path path;
  for (int i = 0; i < kSeeds; ++i) {
    Rng rng(seed, 0, i);
    const double pdf = sampler.sample(path, rng);
    total += weights[i] = pdf > 0 ? static_cast<float>(path.target() / pdf) : 0.0f;
  }
  const DiscreteDistribution start(weights);
  Film film(kChainSide, kChainSide, scene.camera().film().filter);
  film.prepare_splats();
  film.add_splat_count(1);
  FilmObserver observer(film, {.normalization = total / kSeeds / chains / steps}, sampler,
                        Rng(seed, 3, 0));
  for (int c = 0; c < chains; ++c) {
    const uint32_t chosen = start.sample((c + Rng(seed, 1, c).next_float()) / chains).index;
    Rng rng(seed, 0, chosen);
    sampler.sample(path, rng);
    MarkovChain chain(set, path, Rng(seed, 2, c));
    chain.run(steps, observer);
  }
  observer.flush();
  return block_means(film.develop(Layer::Beauty));
}

struct ChainCase {
  std::string name;
  int which;
};

class Chains : public ::testing::TestWithParam<std::tuple<testing::ComparisonScene, ChainCase>> {};

/// Compares chains with the path tracer; `tests` is how many such comparisons there are.
void expect_the_picture(const std::shared_ptr<const Scene>& scene, const MutationSet& set,
                        size_t tests) {
  std::array<Moments, Blocks{}.size()> expected, found;
  for (uint64_t seed = 1; seed <= 8; ++seed) {
    const Blocks means = block_means(testing::render(scene, 8, 2, seed).develop(Layer::Beauty));
    for (size_t i = 0; i < means.size(); ++i) expected[i].add(means[i]);
  }
  for (uint64_t seed = 1; seed <= 12; ++seed) {
    const Blocks means = run_chains(*scene, set, seed, 40, 1000);
    for (size_t i = 0; i < means.size(); ++i) found[i].add(means[i]);
  }
  const double level = statistics::sidak_level(statistics::kFalseAlarms, tests * expected.size());
  for (size_t i = 0; i < expected.size(); ++i) {
    EXPECT_GT(statistics::welch_test(found[i], expected[i]), level)
        << "block " << i << ": " << found[i].mean() << " +- " << found[i].standard_error()
        << " against " << expected[i].mean() << " +- " << expected[i].standard_error();
  }
  EXPECT_LT(found.back().standard_error(), 0.05 * found.back().mean());
}

TEST_P(Chains, ShowThePicture) {
  const auto& [comparison, mutations] = GetParam();
  const auto scene = testing::build(comparison.make());
  expect_the_picture(scene, make_set(*scene, mutations.which), 10 + 6 * 3);
}

template <typename Info>
std::string case_name(const Info& test) {
  return std::get<0>(test.param).name + "_" + std::get<1>(test.param).name;
}

INSTANTIATE_TEST_SUITE_P(AllMutations, Chains,
                         ::testing::Combine(::testing::ValuesIn(testing::comparison_scenes()),
                                            ::testing::Values(ChainCase{"all", 63})),
                         [](const auto& test) { return case_name(test); });

INSTANTIATE_TEST_SUITE_P(
    EachMutation, Chains,
    ::testing::Combine(
        ::testing::ValuesIn(testing::comparison_scenes({"mirror_glass_box", "environment",
                                                        "thin_lens"})),
        ::testing::Values(ChainCase{"bidirectional", kBidirectional}, ChainCase{"lens", kLens},
                          ChainCase{"multi_chain", kMultiChain}, ChainCase{"caustic", kCaustic},
                          ChainCase{"lens_subpath", kSubpath}, ChainCase{"photon_map", kMap})),
    [](const auto& test) { return case_name(test); });

/// Guides that begin as light does, traced over some bounces.
std::vector<GuidePath> traced_guides(const Scene& scene, int count, int bounces, float cone) {
  std::vector<GuidePath> guides;
  for (uint64_t i = 0; guides.size() < static_cast<size_t>(count) && i < 1000; ++i) {
    Rng rng(11, 0, i);
    const auto choice = scene.choose_light(rng.next_float());
    const Vec2 u = rng.next_vec2();
    const auto emission = choice->light->sample_emission(u, rng.next_vec2());
    if (!emission) continue;
    const Vec3 start = choice->light->is_infinite() || choice->light->is_delta_position()
                           ? emission->ray.origin
                           : emission->point.position;
    auto guide = trace_guide(scene, start, emission->ray.direction, bounces);
    if (!guide) continue;
    for (GuideVertex& vertex : guide->vertices) vertex.cone = cone;
    guides.push_back(*guide);
  }
  return guides;
}

struct GuideCase {
  std::string name;
  int count;
  int bounces;
  float cone;  // [rad]
};

class GuidedChains
    : public ::testing::TestWithParam<std::tuple<testing::ComparisonScene, GuideCase>> {};

/// Whatever the guides, they change the noise alone.
TEST_P(GuidedChains, ShowThePicture) {
  const auto& [comparison, wanted] = GetParam();
  const auto scene = testing::build(comparison.make());
  const auto list = traced_guides(*scene, wanted.count, wanted.bounces, wanted.cone);
  const auto guides = GuideMixture::build(scene, list);
  ASSERT_TRUE(guides);
  EXPECT_GE(static_cast<int>(guides->size()), wanted.count / 2);
  expect_the_picture(scene, make_set(*scene, 63, guides), 3 * 5);
}

INSTANTIATE_TEST_SUITE_P(Scenes, GuidedChains,
                         ::testing::Combine(::testing::ValuesIn(testing::comparison_scenes()),
                                            ::testing::Values(GuideCase{"wide", 3, 2, 0.5f},
                                                              GuideCase{"narrow", 2, 3, 0.02f},
                                                              GuideCase{"hundred", 100, 1, 0.1f})),
                         [](const auto& test) { return case_name(test); });

}  // namespace
}  // namespace guidelight

// How fast photons are found, beside nanoflann, a library that does the same: photons on the walls
// of a box, queries anywhere on them in no order; 60 nearest, or a radius that holds 20. Every
// query adds up the power of the photons it finds.
//
//   photon_search_bench [--benchmark_filter=REGEX]

#include <benchmark/benchmark.h>

#include <nanoflann.hpp>

#include "renderer/photons/hash_grid.h"
#include "renderer/photons/kd_tree.h"
#include "renderer/photons/photon.h"

namespace guidelight {
namespace {

constexpr size_t kNearest = 60;
constexpr float kInRadius = 20;
constexpr size_t kQueries = 1 << 18;
constexpr size_t kQueriesPerTask = 1 << 10;

Vec3 point_on_box(Rng& rng) {
  Vec3 p(rng.next_float(), rng.next_float(), rng.next_float());
  const uint32_t wall = rng.next_uint() % 6;
  p[wall / 2] = static_cast<float>(wall % 2);
  return p;
}

const std::vector<Photon>& photons(size_t count) {
  static std::vector<Photon> list;
  if (list.size() == count) return list;
  list.clear();
  Rng rng(1, 0, 0);
  while (list.size() < count) {
    list.push_back(
        make_photon(point_on_box(rng), Vec3(0, 0, 1), Color(rng.next_float()), 2, false));
  }
  return list;
}

const std::vector<Vec3>& query_points() {
  static const std::vector<Vec3> list = [] {
    Rng rng(2, 0, 0);
    std::vector<Vec3> points(kQueries);
    for (Vec3& p : points) p = point_on_box(rng);
    return points;
  }();
  return list;
}

float radius(size_t count) { return std::sqrt(kInRadius * 6 / (kPi * static_cast<float>(count))); }

/// nanoflann's view of the photons.
struct Cloud {
  const std::vector<Photon>& list;
  size_t kdtree_get_point_count() const { return list.size(); }
  float kdtree_get_pt(size_t i, size_t axis) const {
    return list[i].position[static_cast<int>(axis)];
  }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};
using Nanoflann = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<float, Cloud>,
                                                      Cloud, 3, uint32_t>;

/// A radius search of nanoflann's without its list of results.
struct NanoflannVisitor {
  const std::vector<Photon>& list;
  float radius_squared;
  Color sum{0};
  size_t found = 0;

  bool addPoint(float squared, uint32_t index) {
    if (squared < radius_squared) sum += list[index].power(), ++found;
    return true;
  }
  float worstDist() const { return radius_squared; }
  bool full() const { return true; }
  size_t size() const { return found; }
};

size_t photon_count(const benchmark::State& state) { return static_cast<size_t>(state.range(0)); }
int threads(const benchmark::State& state) { return static_cast<int>(state.range(1)); }

void count_photons(benchmark::State& state) {
  state.counters["photons/s"] = {
      static_cast<double>(state.iterations()) * static_cast<double>(photon_count(state)),
      benchmark::Counter::kIsRate};
}

template <class Structure>
void build(benchmark::State& state, Structure&& structure) {
  const auto& list = photons(photon_count(state));
  Parallel parallel(threads(state));
  for (auto _ : state) structure(list, parallel);
  count_photons(state);
}

/// sum(center) is the power of the photons that one query finds, and how many they are.
template <class Sum>
void query(benchmark::State& state, Sum&& sum) {
  Parallel parallel(threads(state));
  const auto& centers = query_points();
  std::vector<std::pair<Color, size_t>> results(kQueries / kQueriesPerTask);
  for (auto _ : state) {
    parallel.for_each(results.size(), [&](size_t task) {
      results[task] = {};
      for (size_t i = task * kQueriesPerTask; i < (task + 1) * kQueriesPerTask; ++i) {
        const auto [power, found] = sum(centers[i]);
        results[task].first += power;
        results[task].second += found;
      }
    });
    benchmark::DoNotOptimize(results.data());
  }
  double found = 0;
  for (const auto& result : results) found += static_cast<double>(result.second);
  state.counters["found"] = found / kQueries;
  state.counters["queries/s"] = {static_cast<double>(state.iterations()) * kQueries,
                                 benchmark::Counter::kIsRate};
}

void build_grid(benchmark::State& state) {
  build(state, [&](const auto& list, Parallel& parallel) {
    benchmark::DoNotOptimize(HashGrid<Photon>(list, 2 * radius(list.size()), parallel));
  });
}

void build_tree(benchmark::State& state) {
  build(state, [](const auto& list, Parallel& parallel) {
    benchmark::DoNotOptimize(KdTree<Photon>(list, parallel));
  });
}

void build_nanoflann(benchmark::State& state) {
  build(state, [](const auto& list, Parallel&) {
    const Cloud cloud{list};
    benchmark::DoNotOptimize(Nanoflann(3, cloud));
  });
}

void radius_grid(benchmark::State& state) {
  const float r = radius(photon_count(state));
  Parallel parallel(threads(state));
  const HashGrid<Photon> grid(photons(photon_count(state)), 2 * r, parallel);
  query(state, [&](Vec3 center) {
    std::pair<Color, size_t> sum{Color(0), 0};
    grid.for_each_within(center, r, [&](const Photon& photon, float) {
      sum.first += photon.power();
      ++sum.second;
    });
    return sum;
  });
}

void radius_nanoflann(benchmark::State& state) {
  const auto& list = photons(photon_count(state));
  const Cloud cloud{list};
  const Nanoflann tree(3, cloud);
  query(state, [&](Vec3 center) {
    NanoflannVisitor visitor{list, sqr(radius(list.size()))};
    tree.radiusSearchCustomCallback(&center.x, visitor);
    return std::pair(visitor.sum, visitor.found);
  });
}

void nearest_tree(benchmark::State& state) {
  Parallel parallel(threads(state));
  const KdTree<Photon> tree(photons(photon_count(state)), parallel);
  query(state, [&](Vec3 center) {
    std::array<Neighbor, kNearest> buffer;
    const Neighbors neighbors = tree.nearest(center, kNearest, kInfinity, buffer);
    Color sum(0);
    for (const Neighbor& n : neighbors.found) sum += tree.items()[n.index].power();
    return std::pair(sum, neighbors.found.size());
  });
}

void nearest_nanoflann(benchmark::State& state) {
  const auto& list = photons(photon_count(state));
  const Cloud cloud{list};
  const Nanoflann tree(3, cloud);
  query(state, [&](Vec3 center) {
    std::array<uint32_t, kNearest> indices;
    std::array<float, kNearest> squared;
    const size_t found = tree.knnSearch(&center.x, kNearest, indices.data(), squared.data());
    Color sum(0);
    for (size_t i = 0; i < found; ++i) sum += list[indices[i]].power();
    return std::pair(sum, found);
  });
}

void sizes_and_threads(benchmark::internal::Benchmark* b) {
  b->ArgsProduct({{10'000, 100'000, 1'000'000}, {1, 2}})->ArgNames({"photons", "threads"});
  b->UseRealTime()->Unit(benchmark::kMillisecond);
}
/// nanoflann 1.4 builds with one thread.
void sizes(benchmark::internal::Benchmark* b) {
  b->ArgsProduct({{10'000, 100'000, 1'000'000}, {1}})->ArgNames({"photons", "threads"});
  b->UseRealTime()->Unit(benchmark::kMillisecond);
}

BENCHMARK(build_grid)->Apply(sizes_and_threads);
BENCHMARK(build_tree)->Apply(sizes_and_threads);
BENCHMARK(build_nanoflann)->Apply(sizes);
BENCHMARK(radius_grid)->Apply(sizes_and_threads);
BENCHMARK(radius_nanoflann)->Apply(sizes_and_threads);
BENCHMARK(nearest_tree)->Apply(sizes_and_threads);
BENCHMARK(nearest_nanoflann)->Apply(sizes_and_threads);

}  // namespace
}  // namespace guidelight

BENCHMARK_MAIN();

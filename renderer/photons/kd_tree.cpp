#include "renderer/photons/kd_tree.h"

#include <algorithm>
#include <bit>

#include "renderer/scene/shape.h"

namespace guidelight {

class PointTree::Builder {
 public:
  Builder(PointTree& tree, std::vector<uint32_t> finite,
          const std::function<Vec3(size_t)>& position)
      : tree_(tree) {
    points_.reserve(finite.size());
    for (const uint32_t index : finite) points_.push_back({position(index), index});
    tree_.order_ = std::move(finite);
    const size_t leaves = std::bit_ceil((points_.size() + kLeafSize - 1) / kLeafSize);
    tree_.leaves_.resize(leaves);
    tree_.nodes_.resize(leaves);
  }

  void build(Parallel& parallel) {
    // The upper levels one after another, all nodes of a level at once; then whole subtrees.
    constexpr size_t kSubtrees = 64;
    size_t first = 1;
    for (; first < std::min(kSubtrees, tree_.leaves_.size()); first *= 2) {
      parallel.for_each(first, [&](size_t i) { split(first + i); });
    }
    parallel.for_each(first, [&](size_t i) { build_subtree(first + i); });
  }

 private:
  struct Point {
    Vec3 position;
    uint32_t index;
  };

  /// The points below a node.
  std::span<Point> points_of(size_t node) {
    // Node i of level d covers the (i - 2^d)-th of 2^d equal parts of the leaves.
    const size_t level_begin = std::bit_floor(node);
    const size_t leaves = tree_.leaves_.size() / level_begin;
    const size_t first = (node - level_begin) * leaves;
    const size_t begin = tree_.leaf_begin(first);
    return std::span(points_).subspan(begin, tree_.leaf_begin(first + leaves) - begin);
  }

  /// Halves the points of an inner node across their longest extent.
  void split(size_t node) {
    const std::span<Point> points = points_of(node);
    Bounds bounds;
    for (const Point& point : points) bounds.extend(point.position);
    const Vec3 extent = bounds.upper - bounds.lower;
    uint32_t axis = extent.y > extent.x ? 1 : 0;
    if (extent.z > extent[axis]) axis = 2;
    const auto middle = points.begin() + static_cast<std::ptrdiff_t>(points_of(2 * node).size());
    std::nth_element(points.begin(), middle, points.end(), [axis](const Point& a, const Point& b) {
      return a.position[axis] < b.position[axis];
    });
    tree_.nodes_[node] = {middle->position[axis], axis};
  }

  void build_subtree(size_t node) {
    if (node >= tree_.leaves_.size()) return fill_leaf(node - tree_.leaves_.size());
    split(node);
    build_subtree(2 * node);
    build_subtree(2 * node + 1);
  }

  void fill_leaf(size_t i) {
    Leaf& leaf = tree_.leaves_[i];
    leaf.x.fill(kInfinity), leaf.y.fill(kInfinity), leaf.z.fill(kInfinity);
    const size_t begin = tree_.leaf_begin(i);
    const size_t size = tree_.leaf_begin(i + 1) - begin;
    for (size_t lane = 0; lane < size; ++lane) {
      const Point& point = points_[begin + lane];
      leaf.x[lane] = point.position.x;
      leaf.y[lane] = point.position.y;
      leaf.z[lane] = point.position.z;
      tree_.order_[begin + lane] = point.index;
    }
  }

  PointTree& tree_;
  std::vector<Point> points_;
};

PointTree::PointTree(size_t count, const std::function<Vec3(size_t)>& position,
                     Parallel& parallel) {
  std::vector<uint32_t> finite;
  finite.reserve(count);
  for (size_t i = 0; i < count; ++i) {
    if (is_finite(position(i))) finite.push_back(static_cast<uint32_t>(i));
  }
  if (!finite.empty()) Builder(*this, std::move(finite), position).build(parallel);
}

/// One search: descends to the nearest leaf first, and remembers the other sides on a stack.
class PointTree::Search {
 public:
  Search(const PointTree& tree, Vec3 center, float max_distance, std::span<Neighbor> heap)
      : tree_(tree), center_(center), bound_(sqr(max_distance)), heap_(heap) {}

  Neighbors run() {
    stack_[0] = {1, 0, Vec3(0)};
    for (int size = 1; size > 0;) {
      Region region = stack_[--size];
      if (region.distance_squared >= bound_) continue;
      while (region.node < tree_.leaves_.size()) {
        const Region far = descend(region);
        if (far.distance_squared < bound_) stack_[size++] = far;
      }
      scan(region.node - tree_.leaves_.size());
    }
    return {heap_.first(count_), bound_};
  }

 private:
  struct Region {
    size_t node;
    float distance_squared;  // from the centre to the region
    Vec3 offset;             // its three components (Arya & Mount 1993)
  };

  /// Makes `region` its child nearer to the centre and returns the other one.
  Region descend(Region& region) const {
    const Node node = tree_.nodes_[region.node];
    const float to_split = center_[node.axis] - node.split;
    const size_t right = to_split >= 0 ? 1 : 0;
    Region far = region;
    region.node = 2 * region.node + right;
    far.node = 2 * far.node + 1 - right;
    far.distance_squared += sqr(to_split) - sqr(far.offset[node.axis]);
    far.offset[node.axis] = to_split;
    return far;
  }

  void scan(size_t leaf_index) {
    const Leaf& leaf = tree_.leaves_[leaf_index];
    std::array<float, kLeafSize> squared;
    for (size_t i = 0; i < kLeafSize; ++i) {
      squared[i] =
          sqr(leaf.x[i] - center_.x) + sqr(leaf.y[i] - center_.y) + sqr(leaf.z[i] - center_.z);
    }
    const auto begin = static_cast<uint32_t>(tree_.leaf_begin(leaf_index));
    for (uint32_t i = 0; i < kLeafSize; ++i) {
      if (squared[i] < bound_) insert({squared[i], begin + i});
    }
  }

  static bool is_nearer(const Neighbor& a, const Neighbor& b) {
    return a.distance_squared < b.distance_squared;
  }

  void insert(Neighbor neighbor) {
    if (count_ < heap_.size()) {
      heap_[count_++] = neighbor;
      if (count_ < heap_.size()) return;
      std::make_heap(heap_.begin(), heap_.end(), is_nearer);
    } else {
      replace_farthest(neighbor);
    }
    bound_ = heap_[0].distance_squared;
  }

  void replace_farthest(Neighbor neighbor) {
    size_t hole = 0;
    for (size_t child = 1; child < count_; child = 2 * hole + 1) {
      if (child + 1 < count_ && is_nearer(heap_[child], heap_[child + 1])) ++child;
      if (!is_nearer(neighbor, heap_[child])) break;
      heap_[hole] = heap_[child];
      hole = child;
    }
    heap_[hole] = neighbor;
  }

  const PointTree& tree_;
  Vec3 center_;
  float bound_;               // squared distance below which points are wanted
  std::span<Neighbor> heap_;  // once it is full, the farthest is on top
  size_t count_ = 0;
  std::array<Region, 64> stack_;
};

Neighbors PointTree::nearest(Vec3 center, size_t k, float max_distance,
                             std::span<Neighbor> buffer) const {
  const std::span<Neighbor> heap = buffer.first(std::min(k, buffer.size()));
  if (order_.empty() || heap.empty() || !(max_distance > 0) || !is_finite(center)) {
    return {{}, max_distance > 0 ? sqr(max_distance) : 0};
  }
  return Search(*this, center, max_distance, heap).run();
}

}  // namespace guidelight

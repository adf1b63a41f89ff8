#pragma once

#include <array>
#include <functional>
#include <span>
#include <vector>

#include "renderer/math/vector.h"
#include "renderer/parallel/parallel.h"

namespace guidelight {

/// A point that a search found.
struct Neighbor {
  float distance_squared;
  uint32_t index;  // of the tree's items
};

/// What the search of k neighbours found, in no particular order.
struct Neighbors {
  std::span<const Neighbor> found;
  /// Squared radius of the ball they fill: up to the farthest if there are k of them, otherwise the
  /// maximum distance.
  float radius_squared;
};

/// Balanced kd-tree over points. All leaves stand at one depth and hold up to 8 points, so that
/// node i has the children 2i and 2i+1 and no pointers are needed. Points that are not finite are
/// left out.
class PointTree {
 public:
  PointTree() = default;
  /// Positions(i), i < count.
  PointTree(size_t count, const std::function<Vec3(size_t)>& position, Parallel& parallel);

  /// Index of the point that stands at each place of the tree, leaf by leaf.
  std::span<const uint32_t> order() const { return order_; }

  /// The k points nearest to `center` among those nearer than `max_distance`, by their places in
  /// order(). Written to `buffer`, whose size limits k.
  Neighbors nearest(Vec3 center, size_t k, float max_distance, std::span<Neighbor> buffer) const;

  size_t bytes() const {
    return nodes_.capacity() * sizeof(Node) + leaves_.capacity() * sizeof(Leaf) +
           order_.capacity() * sizeof(uint32_t);
  }

 private:
  static constexpr size_t kLeafSize = 8;
  struct Node {
    float split;  // lower coordinates are in the left child, higher ones in the right
    uint32_t axis;
  };
  struct alignas(32) Leaf {
    std::array<float, kLeafSize> x, y, z;  // unused places are infinitely far away
  };
  class Builder;
  class Search;

  size_t leaf_begin(size_t leaf) const { return order_.size() * leaf / leaves_.size(); }

  std::vector<Node> nodes_;  // the root is node 1
  std::vector<Leaf> leaves_;
  std::vector<uint32_t> order_;
};

/// Finds the k nearest items. Items have a member `position`; they are copied in the tree's order.
/// Nothing depends on the number of threads.
template <class Item>
class KdTree {
 public:
  KdTree() = default;
  KdTree(std::span<const Item> items, Parallel& parallel)
      : tree_(
            items.size(), [&](size_t i) { return items[i].position; }, parallel) {
    items_.reserve(tree_.order().size());
    for (const uint32_t index : tree_.order()) items_.push_back(items[index]);
  }

  /// All items whose position is finite, in the order that Neighbor::index means.
  std::span<const Item> items() const { return items_; }

  /// See PointTree.
  Neighbors nearest(Vec3 center, size_t k, float max_distance, std::span<Neighbor> buffer) const {
    return tree_.nearest(center, k, max_distance, buffer);
  }

  size_t bytes() const { return tree_.bytes() + items_.capacity() * sizeof(Item); }

 private:
  PointTree tree_;
  std::vector<Item> items_;
};

}  // namespace guidelight

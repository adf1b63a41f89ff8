#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include "renderer/parallel/parallel.h"
#include "renderer/scene/shape.h"

/// What a hash grid needs to know that does not depend on the type of its items.
namespace guidelight {

/// Cubic cells over a box, folded into a table by a hash. Neighbours along x stand side by side in
/// the table, so that a row of cells is one range of it, or two where it wraps around.
class HashedCells {
 public:
  using Cell = glm::ivec3;

  HashedCells() = default;
  /// The table has a power of two of entries, enough for `items`. The side grows if there would be
  /// more than 2²⁰ cells along an axis.
  HashedCells(const Bounds& bounds, float side, size_t items);

  /// The cell of a point; those outside the box get the nearest cell. Monotonic along each axis.
  Cell cell(Vec3 p) const {
    return Cell(glm::clamp((p - bounds_.lower) * inverse_side_, Vec3(0.0f), Vec3(last_)));
  }

  float side() const { return 1 / inverse_side_; }
  uint32_t table_size() const { return mask_ + 1; }
  /// Entry of the table for a point of the box; table_size() if the point is not finite.
  uint32_t entry_of(Vec3 p) const {
    if (!is_finite(p)) return table_size();
    const Cell c = cell(p);
    return (row(c.y, c.z) + static_cast<uint32_t>(c.x)) & mask_;
  }

  struct CellRange {
    Cell first;
    Cell last;  // inclusive
    uint64_t row_count() const {
      return (uint64_t(last.y) - first.y + 1) * (uint64_t(last.z) - first.z + 1);
    }
  };
  /// The cells that a ball meets; empty if it misses the box, or is not a number, or has no volume.
  std::optional<CellRange> overlapped(Vec3 center, float radius) const;

  /// Calls visit(first, last) for the ranges of entries that hold the cells [x0,x1] of a row.
  template <class Visit>
  void for_each_range(int x0, int x1, int y, int z, Visit&& visit) const {
    const auto count = static_cast<uint32_t>(x1 - x0 + 1);
    if (count > mask_) return visit(0u, table_size());
    const uint32_t first = (row(y, z) + static_cast<uint32_t>(x0)) & mask_;
    const uint32_t last = first + count;
    visit(first, std::min(last, table_size()));
    if (last > table_size()) visit(0u, last - table_size());
  }

 private:
  /// Entry of the row's first cell, before it is folded (Teschner et al. 2003, "Optimized Spatial
  /// Hashing for Collision Detection of Deformable Objects").
  static uint32_t row(int y, int z) {
    const uint32_t h = static_cast<uint32_t>(y) * 19349663u ^ static_cast<uint32_t>(z) * 83492791u;
    return h ^ h >> 15;
  }

  Bounds bounds_;
  float inverse_side_ = 1;
  Cell last_{0};
  uint32_t mask_ = 0;  // of a table of a power of two of entries
};

/// Calls body(begin, end) in parallel for parts of [0,count) that are large enough to be worth it.
void for_each_chunk(size_t count, Parallel& parallel,
                    const std::function<void(size_t, size_t)>& body);

/// Box of the positions(i), i < count, that are finite.
Bounds finite_bounds(size_t count, const std::function<Vec3(size_t)>& position, Parallel& parallel);

/// Sorts items by their entry in a table; keeps its memory from one sort to the next.
class EntrySorter {
 public:
  /// Stable sort of items by their entry, each below `entry_count`.
  void sort(std::span<const uint32_t> entry_of_item, uint32_t entry_count, Parallel& parallel);

  /// Where each entry's items begin in `order`; and the end.
  std::span<const uint32_t> begin() const { return begin_; }
  /// Indices of items.
  std::span<const uint32_t> order() const { return order_; }
  size_t bytes() const;

 private:
  struct Item {
    uint32_t entry;
    uint32_t index;
  };

  void sort_into_buckets(std::span<const uint32_t> entry_of_item, uint32_t bucket_count,
                         Parallel& parallel);
  void sort_bucket(uint32_t bucket, uint32_t entry_count);

  std::vector<uint32_t> begin_;
  std::vector<uint32_t> order_;
  // Items by the high bits of their entry, stable: bucket i is items_[bucket_begin_[i],
  // bucket_begin_[i+1]).
  std::vector<uint32_t> bucket_begin_;
  std::vector<Item> items_;
};

}  // namespace guidelight

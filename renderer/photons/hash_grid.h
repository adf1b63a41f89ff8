#pragma once

#include <array>
#include <span>
#include <vector>

#include "renderer/parallel/prefetch.h"
#include "renderer/photons/hashed_cells.h"

namespace guidelight {

/// Finds all items within a radius. Items have a member `position`; they are copied and sorted by
/// cell, so that a query reads contiguous memory, and keep their order within an entry of the
/// table: nothing depends on the number of threads. Items whose position is not finite are never
/// found.
template <class Item>
class HashGrid {
 public:
  HashGrid() = default;
  /// `cell_side` is about twice the usual radius: a query then touches at most 8 cells. Any value
  /// works, some are slow.
  HashGrid(std::span<const Item> items, float cell_side, Parallel& parallel) {
    rebuild(items, cell_side, parallel);
  }
  /// The same in the memory of the grid before.
  void rebuild(std::span<const Item> items, float cell_side, Parallel& parallel);

  /// Asks for the memory that a search of the usual radius will read. To be called twice, with time
  /// between, because the second needs the first: where the cells begin, then (`items`) what they
  /// hold.
  void prefetch(Vec3 center, bool items) const;

  /// Calls visit(item, squared distance) once for each item nearer to `center` than `radius`, in an
  /// order that does not depend on threads.
  template <class Visit>
  void for_each_within(Vec3 center, float radius, Visit&& visit) const;

  /// All items, sorted; those with a position that is not finite come last.
  std::span<const Item> items() const { return items_; }
  size_t bytes() const {
    return items_.capacity() * sizeof(Item) + entries_.capacity() * sizeof(uint32_t) +
           sorter_.bytes();
  }

 private:
  HashedCells cells_;
  std::vector<Item> items_;
  std::vector<uint32_t> entries_;  // of the items, before they are sorted
  EntrySorter sorter_;             // entry i of the table holds items_[begin()[i], begin()[i+1])
};

// ---------------------------------------------------------------------------------------------------

template <class Item>
void HashGrid<Item>::rebuild(std::span<const Item> items, float cell_side, Parallel& parallel) {
  const auto position = [&](size_t i) { return items[i].position; };
  cells_ = HashedCells(finite_bounds(items.size(), position, parallel), cell_side, items.size());

  entries_.resize(items.size());
  for_each_chunk(items.size(), parallel, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) entries_[i] = cells_.entry_of(items[i].position);
  });
  sorter_.sort(entries_, cells_.table_size() + 1, parallel);
  items_.resize(items.size());
  for_each_chunk(items.size(), parallel, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) items_[i] = items[sorter_.order()[i]];
  });
}

template <class Item>
void HashGrid<Item>::prefetch(Vec3 center, bool items) const {
  if (items_.empty()) return;
  const auto begin = sorter_.begin();
  const auto ask = [&](uint32_t first, uint32_t last) {
    if (!items) return guidelight::prefetch(&begin[first]);
    constexpr uint32_t kItems = 8;  // enough to start on
    constexpr uint32_t kPerLine = std::max<size_t>(1, 64 / sizeof(Item));
    const uint32_t end = std::min(begin[last], begin[first] + kItems);
    for (uint32_t i = begin[first]; i < end; i += kPerLine) guidelight::prefetch(&items_[i]);
  };
  const HashedCells::Cell lower = cells_.cell(center - 0.5f * cells_.side());
  const HashedCells::Cell upper = cells_.cell(center + 0.5f * cells_.side());
  for (int z = lower.z; z <= upper.z; ++z) {
    for (int y = lower.y; y <= upper.y; ++y) cells_.for_each_range(lower.x, upper.x, y, z, ask);
  }
}

template <class Item>
template <class Visit>
void HashGrid<Item>::for_each_within(Vec3 center, float radius, Visit&& visit) const {
  const float radius_squared = sqr(radius);
  const auto scan = [&](uint32_t begin, uint32_t end, auto&& belongs) {
    // Which candidates are near is hard to predict, so they are sorted out without a branch.
    constexpr uint32_t kBlock = 32;
    std::array<uint32_t, kBlock> near_index;
    std::array<float, kBlock> near_squared;
    while (begin < end) {
      const uint32_t block_end = std::min(begin + kBlock, end);
      uint32_t count = 0;
      for (; begin < block_end; ++begin) {
        const float squared = length_squared(items_[begin].position - center);
        near_index[count] = begin;
        near_squared[count] = squared;
        count += squared < radius_squared ? 1 : 0;
      }
      for (uint32_t i = 0; i < count; ++i) {
        const Item& item = items_[near_index[i]];
        if (belongs(item.position)) visit(item, near_squared[i]);
      }
    }
  };
  const auto range = cells_.overlapped(center, radius);
  if (!range) return;
  if (range->row_count() > items_.size()) {
    scan(0, sorter_.begin()[cells_.table_size()], [](Vec3) { return true; });
    return;
  }
  for (int z = range->first.z; z <= range->last.z; ++z) {
    for (int y = range->first.y; y <= range->last.y; ++y) {
      // Another row may share entries of the table with this one.
      const auto belongs = [&](Vec3 p) {
        const HashedCells::Cell cell = cells_.cell(p);
        return cell.y == y && cell.z == z;
      };
      cells_.for_each_range(range->first.x, range->last.x, y, z,
                            [&](uint32_t first, uint32_t last) {
                              scan(sorter_.begin()[first], sorter_.begin()[last], belongs);
                            });
    }
  }
}

}  // namespace guidelight

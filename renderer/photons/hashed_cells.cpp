#include "renderer/photons/hashed_cells.h"

#include <array>
#include <bit>
#include <utility>

namespace guidelight {

HashedCells::HashedCells(const Bounds& bounds, float side, size_t items) : bounds_(bounds) {
  if (bounds.empty()) return;
  constexpr float kMaxCells = 0x1p20f;
  const Vec3 extent = bounds.upper - bounds.lower;
  const float smallest = max_component(extent) / kMaxCells;
  inverse_side_ = 1 / (side > smallest ? side : smallest);
  const bool is_usable = inverse_side_ > 0 && std::isfinite(inverse_side_);
  if (!is_usable) inverse_side_ = 1;  // everything is in one place, or far beyond any scene
  last_ = Cell(glm::min(extent * inverse_side_, Vec3(kMaxCells)));
  const size_t entries = std::clamp<size_t>(items, 1, size_t{1} << 30);
  mask_ = static_cast<uint32_t>(std::bit_ceil(entries) - 1);
}

std::optional<HashedCells::CellRange> HashedCells::overlapped(Vec3 center, float radius) const {
  // A little more than the radius, against rounding.
  const Vec3 reach = radius + 4 * kFloatEpsilon * (glm::abs(center) + radius);
  const Vec3 lower = center - reach;
  const Vec3 upper = center + reach;
  const bool meets_box = radius > 0 && glm::all(glm::lessThanEqual(lower, bounds_.upper)) &&
                         glm::all(glm::greaterThanEqual(upper, bounds_.lower));
  if (!meets_box) return std::nullopt;
  return CellRange{cell(lower), cell(upper)};
}

namespace {

constexpr size_t kChunk = size_t{1} << 14;

size_t chunk_count(size_t count) { return (count + kChunk - 1) / kChunk; }

}  // namespace

void for_each_chunk(size_t count, Parallel& parallel,
                    const std::function<void(size_t, size_t)>& body) {
  parallel.for_each(chunk_count(count), [&](size_t chunk) {
    body(chunk * kChunk, std::min(count, (chunk + 1) * kChunk));
  });
}

Bounds finite_bounds(size_t count, const std::function<Vec3(size_t)>& position,
                     Parallel& parallel) {
  std::vector<Bounds> parts(chunk_count(count));
  for_each_chunk(count, parallel, [&](size_t begin, size_t end) {
    Bounds part;
    for (size_t i = begin; i < end; ++i) {
      const Vec3 p = position(i);
      if (is_finite(p)) part.extend(p);
    }
    parts[begin / kChunk] = part;
  });
  Bounds bounds;
  for (const Bounds& part : parts) bounds.extend(part);
  return bounds;
}

namespace {

// Counting sort in two steps, because a table of counters for each thread would not fit into its
// cache: first by the high bits, then every bucket on its own.
constexpr int kEntryBits = 10;
constexpr uint32_t kBucketEntries = 1u << kEntryBits;

}  // namespace

void EntrySorter::sort_into_buckets(std::span<const uint32_t> entry_of_item, uint32_t bucket_count,
                                    Parallel& parallel) {
  const size_t chunks = chunk_count(entry_of_item.size());
  std::vector<uint32_t> counts(chunks * bucket_count);  // by chunk, then bucket
  for_each_chunk(entry_of_item.size(), parallel, [&](size_t begin, size_t end) {
    uint32_t* count = &counts[begin / kChunk * bucket_count];
    for (size_t i = begin; i < end; ++i) ++count[entry_of_item[i] >> kEntryBits];
  });

  bucket_begin_.resize(bucket_count + 1);
  items_.resize(entry_of_item.size());
  uint32_t sum = 0;
  for (uint32_t bucket = 0; bucket < bucket_count; ++bucket) {
    bucket_begin_[bucket] = sum;
    for (size_t chunk = 0; chunk < chunks; ++chunk) {
      sum += std::exchange(counts[chunk * bucket_count + bucket], sum);
    }
  }
  bucket_begin_[bucket_count] = sum;

  for_each_chunk(entry_of_item.size(), parallel, [&](size_t begin, size_t end) {
    uint32_t* next = &counts[begin / kChunk * bucket_count];
    for (size_t i = begin; i < end; ++i) {
      const uint32_t entry = entry_of_item[i];
      items_[next[entry >> kEntryBits]++] = {entry, static_cast<uint32_t>(i)};
    }
  });
}

void EntrySorter::sort_bucket(uint32_t bucket, uint32_t entry_count) {
  std::array<uint32_t, kBucketEntries> next{};
  const std::span items(items_.begin() + bucket_begin_[bucket],
                        items_.begin() + bucket_begin_[bucket + 1]);
  for (const Item& item : items) ++next[item.entry % kBucketEntries];
  uint32_t sum = bucket_begin_[bucket];
  const uint32_t first_entry = bucket * kBucketEntries;
  const uint32_t end_entry = std::min(first_entry + kBucketEntries, entry_count);
  for (uint32_t entry = first_entry; entry < end_entry; ++entry) {
    uint32_t& begin = next[entry - first_entry];
    begin_[entry] = sum;
    sum += std::exchange(begin, sum);
  }
  for (const Item& item : items) order_[next[item.entry % kBucketEntries]++] = item.index;
}

void EntrySorter::sort(std::span<const uint32_t> entry_of_item, uint32_t entry_count,
                       Parallel& parallel) {
  const uint32_t bucket_count = (entry_count + kBucketEntries - 1) / kBucketEntries;
  sort_into_buckets(entry_of_item, bucket_count, parallel);
  begin_.resize(entry_count + 1);
  order_.resize(entry_of_item.size());
  parallel.for_each(bucket_count, [&](size_t bucket) {
    sort_bucket(static_cast<uint32_t>(bucket), entry_count);
  });
  begin_[entry_count] = static_cast<uint32_t>(entry_of_item.size());
}

size_t EntrySorter::bytes() const {
  return (begin_.capacity() + order_.capacity() + bucket_begin_.capacity()) * sizeof(uint32_t) +
         items_.capacity() * sizeof(Item);
}

}  // namespace guidelight

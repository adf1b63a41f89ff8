#include "renderer/integrators/pixel_history.h"

#include <algorithm>

namespace guidelight {

void PixelHistory::watch(const std::vector<Pixel>& pixels) {
  const std::lock_guard lock(mutex_);
  std::vector<Record> records;
  for (const Pixel& pixel : pixels) {
    const auto known = std::ranges::find(records_, pixel, &Record::pixel);
    records.push_back(known != records_.end() ? std::move(*known) : Record{.pixel = pixel});
  }
  records_ = std::move(records);
}

std::vector<PixelHistory::Entry> PixelHistory::of(Pixel pixel) const {
  const std::lock_guard lock(mutex_);
  const auto known = std::ranges::find(records_, pixel, &Record::pixel);
  return known != records_.end() ? known->entries : std::vector<Entry>{};
}

namespace {

PixelHistory::Entry entry_of(const Film& film, PixelHistory::Pixel pixel) {
  const auto estimates = film.density_estimates(pixel.x, pixel.y);
  const float share = 1 / static_cast<float>(estimates.size());
  PixelHistory::Entry entry{};
  entry.emitted = estimates.front().emitted;
  for (const DensityEstimate& estimate : estimates) {
    entry.count += share * estimate.count;
    entry.radius += share * std::sqrt(estimate.radius_squared);
  }
  entry.estimate = film.develop_pixel(Layer::Beauty, pixel.x, pixel.y);
  entry.error = std::sqrt(film.develop_pixel(Layer::Variance, pixel.x, pixel.y)[0]);
  return entry;
}

}  // namespace

void PixelHistory::record(const Film& film) {
  const std::lock_guard lock(mutex_);
  for (Record& record : records_) {
    const auto [x, y] = record.pixel;
    if (x < 0 || y < 0 || x >= film.width() || y >= film.height()) continue;
    if (film.density_estimates(x, y).empty() || ++record.passes % record.stride != 0) continue;
    record.entries.push_back(entry_of(film, record.pixel));
    if (record.entries.size() < kMostEntries) continue;
    for (size_t i = 0; i < kMostEntries / 2; ++i) record.entries[i] = record.entries[2 * i + 1];
    record.entries.resize(kMostEntries / 2);
    record.stride *= 2;
  }
}

}  // namespace guidelight

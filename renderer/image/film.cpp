#include "renderer/image/film.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <new>

#include "renderer/error.h"

namespace guidelight {

Film::Film(int width, int height, const FilterSettings& filter)
    : width_(width), height_(height), filter_(filter) {
  if (width <= 0 || height <= 0) {
    throw Error("a film of {}x{} pixels has nothing to show: give it at least one pixel", width,
                height);
  }
  const size_t pixels = static_cast<size_t>(width) * height;
  try {
    pixels_ = ZeroedArray<Pixel>(pixels);
  } catch (const std::bad_alloc&) {
    throw Error(
        "a film of {}x{} pixels needs {:.1f} GiB of memory, more than there is: render fewer "
        "pixels or a crop window",
        width, height, static_cast<double>(pixels) * sizeof(Pixel) / (1 << 30));
  }
}

// -- Samples and splats.

void Film::add_sample(int x, int y, const FilmSample& sample) {
  const size_t i = index(x, y);
  Pixel& pixel = pixels_[i];
  ++pixel.samples;
  if (has_splats()) ++statistics_[i].samples;
  const Color beauty = sample.direct + sample.indirect;
  if (!is_finite(beauty + sample.caustic + sample.merging)) {
    ++pixel.rejected;
    return;
  }
  const double weight = sample.filter_weight;
  for (int c = 0; c < 3; ++c) {
    pixel.radiance.direct[c] += weight * sample.direct[c];
    pixel.radiance.indirect[c] += weight * sample.indirect[c];
    pixel.radiance.caustic[c] += weight * sample.caustic[c];
    pixel.radiance.merging[c] += weight * sample.merging[c];
    pixel.albedo[c] += weight * sample.albedo[c];
    pixel.normal[c] += weight * sample.normal[c];
  }
  if (sample.depth < kInfinity) {
    pixel.depth += sample.depth;
    ++pixel.hits;
  }
  const double y_weighted = weight * luminance(beauty);
  pixel.luminance_squared += sqr(y_weighted);
  if (has_splats()) statistics_[i].sample_sum += static_cast<float>(y_weighted);
  if (has_density_estimates()) density_.add_bias(i, weight * sample.bias);
}

void Film::prepare_density_estimates(int per_pixel) {
  if (has_density_estimates() && density_.per_pixel() != per_pixel) {
    throw Error("the film has {} density estimates per pixel, not {}: go on with the same settings",
                density_.per_pixel(), per_pixel);
  }
  if (!has_density_estimates()) density_ = DensityEstimates(width_, height_, per_pixel);
}

std::span<DensityEstimate> Film::density_estimates(int x, int y) {
  if (!has_density_estimates()) return {};
  return density_.at(index(x, y));
}

std::span<const DensityEstimate> Film::density_estimates(int x, int y) const {
  if (!has_density_estimates()) return {};
  return density_.at(index(x, y));
}

void Film::prepare_splats() {
  if (has_splats()) return;
  splats_ = ZeroedArray<Radiance>(pixels_.size());
  statistics_ = ZeroedArray<PassStatistics>(pixels_.size());
}

namespace {

template <typename Number>
void add_atomically(Number& sum, Number value) {
  std::atomic_ref(sum).fetch_add(value, std::memory_order_relaxed);
}

void add_atomically(double (&sums)[3], double weight, Color color) {
  for (int c = 0; c < 3; ++c) add_atomically(sums[c], weight * color[c]);
}

}  // namespace

Film::SplatTarget Film::splat_target(Vec2 raster, Vec2 u) const {
  // As a camera sample belongs to one pixel, so does a splat: the filter chooses which.
  const Filter::PixelChoice x = filter_.choose_pixel(raster.x, u.x);
  const Filter::PixelChoice y = filter_.choose_pixel(raster.y, u.y);
  if (x.pixel < 0 || y.pixel < 0 || x.pixel >= width_ || y.pixel >= height_) return {0, 0};
  return {index(x.pixel, y.pixel), static_cast<double>(x.weight) * y.weight};
}

void Film::add_splat_at(const SplatTarget& target, const Splat& splat) {
  if (target.weight == 0) return;
  if (!is_finite(splat.contribution)) {
    add_atomically(rejected_splats_, uint64_t{1});
    return;
  }
  Radiance& sums = splats_[target.pixel];
  add_atomically(splat.direct ? sums.direct : sums.indirect, target.weight, splat.contribution);
  if (splat.caustic) add_atomically(sums.caustic, target.weight, splat.contribution);
  add_atomically(statistics_[target.pixel].splat_sum,
                 static_cast<float>(target.weight * luminance(splat.contribution)));
}

void Film::add_splats(std::span<const Splat> splats, std::span<const Vec2> u) {
  // Splats are all over the picture, and hardly one finds its pixel in the cache.
  constexpr size_t kBatch = 32;
  std::array<SplatTarget, kBatch> targets;
  for (size_t begin = 0; begin < splats.size(); begin += kBatch) {
    const size_t count = std::min(kBatch, splats.size() - begin);
    for (size_t i = 0; i < count; ++i) {
      targets[i] = splat_target(splats[begin + i].raster, u[begin + i]);
      Radiance& sums = splats_[targets[i].pixel];
      auto& sum = splats[begin + i].direct ? sums.direct : sums.indirect;
      __builtin_prefetch(&sum[0], 1);
      __builtin_prefetch(&sum[2], 1);  // may be on the next cache line
      __builtin_prefetch(&statistics_[targets[i].pixel], 1);
    }
    for (size_t i = 0; i < count; ++i) add_splat_at(targets[i], splats[begin + i]);
  }
}

void Film::add_splat_count(uint64_t light_paths) { add_atomically(splat_count_, light_paths); }

double Film::splat_scale(uint64_t light_paths) const {
  return light_paths > 0 ? static_cast<double>(pixels_.size()) / light_paths : 0.0;
}

void Film::finish_pass() {
  if (!has_splats()) return;
  const double scale = splat_scale(splat_count_ - finished_splat_count_);
  for (PassStatistics& pass : statistics_) {
    const double mean_sample = pass.samples > 0 ? pass.sample_sum / pass.samples : 0.0;
    const double estimate = mean_sample + scale * pass.splat_sum;
    pass = {.sum = pass.sum + estimate, .squares = pass.squares + sqr(estimate)};
  }
  finished_splat_count_ = splat_count_;
  ++finished_passes_;
}

// -- Sums.

template <typename Visit, typename... Radiances>
void Film::visit_radiance(Visit&& visit, Radiances&... radiance) {
  for (int c = 0; c < 3; ++c) visit(radiance.direct[c]...);
  for (int c = 0; c < 3; ++c) visit(radiance.indirect[c]...);
  for (int c = 0; c < 3; ++c) visit(radiance.caustic[c]...);
  for (int c = 0; c < 3; ++c) visit(radiance.merging[c]...);
}

template <typename Visit, typename... Pixels>
void Film::visit_pixel(Visit&& visit, Pixels&... pixel) {
  visit_radiance(visit, pixel.radiance...);
  for (int c = 0; c < 3; ++c) visit(pixel.albedo[c]...);
  for (int c = 0; c < 3; ++c) visit(pixel.normal[c]...);
  visit(pixel.depth...);
  visit(pixel.luminance_squared...);
  visit(pixel.hits...);
  visit(pixel.samples...);
  visit(pixel.rejected...);
}

template <typename Visit, typename... Films>
void Film::visit_splats(Visit&& visit, size_t i, Films&... film) {
  visit_radiance(visit, film.splats_[i]...);
  visit(film.statistics_[i].sum...);
  visit(film.statistics_[i].squares...);
}

namespace {

// Numbers of the state, as the functions above list them.
constexpr size_t kFilmState = 5;
constexpr size_t kPixelState = 23;
constexpr size_t kSplatState = 14;  // of each pixel of a film with splats

}  // namespace

void Film::merge(const Film& other) {
  if (other.width_ != width_ || other.height_ != height_) {
    throw Error("films of {}x{} and {}x{} pixels cannot be merged: render both at one size", width_,
                height_, other.width_, other.height_);
  }
  const auto add = [](auto& sum, const auto& more) { sum += more; };
  for (size_t i = 0; i < pixels_.size(); ++i) visit_pixel(add, pixels_[i], other.pixels_[i]);
  if (other.has_density_estimates()) {
    prepare_density_estimates(other.density_.per_pixel());
    density_.merge(other.density_);
  }
  if (!other.has_splats()) return;
  prepare_splats();
  for (size_t i = 0; i < pixels_.size(); ++i) visit_splats(add, i, *this, other);
  splat_count_ += other.splat_count_;
  finished_splat_count_ += other.splat_count_;
  finished_passes_ += other.finished_passes_;
  rejected_splats_ += other.rejected_splats_;
}

void Film::clear() { *this = Film(width_, height_, filter_.settings()); }

std::vector<double> Film::state() const {
  std::vector<double> result;
  result.reserve(kFilmState + kPixelState * pixels_.size() + kSplatState * splats_.size() +
                 density_.state_size());
  const auto store = [&](auto value) { result.push_back(static_cast<double>(value)); };
  store(has_splats());
  store(density_.per_pixel());
  store(splat_count_);
  store(finished_passes_);
  store(rejected_splats_);
  for (const Pixel& pixel : pixels_) visit_pixel(store, pixel);
  for (size_t i = 0; i < splats_.size(); ++i) visit_splats(store, i, *this);
  DensityEstimates::visit_state(store, density_);
  return result;
}

void Film::restore(std::span<const double> state) {
  clear();
  const bool splats = !state.empty() && state[0] > 0;
  const double per_pixel = state.size() > 1 ? state[1] : 0.0;
  if (splats) prepare_splats();
  if (per_pixel >= 1 &&
      per_pixel * static_cast<double>(pixels_.size()) <= static_cast<double>(state.size())) {
    prepare_density_estimates(static_cast<int>(per_pixel));
  }
  if (state.size() != kFilmState + kPixelState * pixels_.size() + kSplatState * splats_.size() +
                          density_.state_size()) {
    throw Error("the saved film does not have {}x{} pixels: resume at the size it was saved at",
                width_, height_);
  }
  const double* next = &state[2];
  const auto load = [&](auto& value) {
    value = static_cast<std::remove_reference_t<decltype(value)>>(*next++);
  };
  load(splat_count_);
  load(finished_passes_);
  load(rejected_splats_);
  for (Pixel& pixel : pixels_) visit_pixel(load, pixel);
  for (size_t i = 0; i < splats_.size(); ++i) visit_splats(load, i, *this);
  DensityEstimates::visit_state(load, density_);
  finished_splat_count_ = splat_count_;
}

// -- Pictures and figures.

Film::Estimates Film::estimates(size_t i) const {
  const Pixel& pixel = pixels_[i];
  const auto beauty = [&](int c) { return pixel.radiance.direct[c] + pixel.radiance.indirect[c]; };
  const uint64_t count = has_splats() ? finished_passes_ : pixel.samples;
  if (count == 0) return {};
  const double n = static_cast<double>(count);
  const double mean =
      (has_splats() ? statistics_[i].sum
                    : 0.2126 * beauty(0) + 0.7152 * beauty(1) + 0.0722 * beauty(2)) /
      n;
  const double squares = has_splats() ? statistics_[i].squares : pixel.luminance_squared;
  const double variance = count > 1 ? std::max(0.0, squares / n - sqr(mean)) / (n - 1) : 0.0;
  return {count, mean, variance};
}

void Film::develop_pixel(Layer layer, size_t i, float* out) const {
  const Pixel& pixel = pixels_[i];
  const double scale = pixel.samples > 0 ? 1.0 / pixel.samples : 0.0;
  const auto store = [&](auto&& value_of) {
    for (int c = 0; c < 3; ++c) out[c] = static_cast<float>(value_of(c));
  };
  const auto radiance = [&](auto&& sum_of) {
    if (!has_splats()) return store([&](int c) { return sum_of(pixel.radiance, c) * scale; });
    const double per_path = splat_scale(splat_count_);
    store([&](int c) {
      return sum_of(pixel.radiance, c) * scale + sum_of(splats_[i], c) * per_path;
    });
  };
  switch (layer) {
    case Layer::Beauty:
      radiance([](const Radiance& r, int c) { return r.direct[c] + r.indirect[c]; });
      break;
    case Layer::Direct:
      radiance([](const Radiance& r, int c) { return r.direct[c]; });
      break;
    case Layer::Indirect:
      radiance([](const Radiance& r, int c) { return r.indirect[c]; });
      break;
    case Layer::Caustic:
      radiance([](const Radiance& r, int c) { return r.caustic[c]; });
      break;
    case Layer::Connection:
      radiance([](const Radiance& r, int c) { return r.direct[c] + r.indirect[c] - r.merging[c]; });
      break;
    case Layer::Merging:
      radiance([](const Radiance& r, int c) { return r.merging[c]; });
      break;
    case Layer::Albedo:
      store([&](int c) { return pixel.albedo[c] * scale; });
      break;
    case Layer::Normal:
      store([&](int c) { return pixel.normal[c] * scale; });
      break;
    case Layer::Depth:
      out[0] = pixel.hits ? static_cast<float>(pixel.depth / pixel.hits) : 0;
      break;
    case Layer::SampleCount:
      out[0] = static_cast<float>(pixel.samples);
      break;
    case Layer::Variance:
      out[0] = static_cast<float>(estimates(i).variance);
      break;
  }
}

Image Film::develop(Layer layer) const {
  Image image(width_, height_, layer_channels(layer));
  develop_rows(layer, 0, height_, image);
  return image;
}

void Film::develop_rows(Layer layer, int y0, int y1, Image& out) const {
  const size_t end = static_cast<size_t>(y1) * width_;
  for (size_t i = static_cast<size_t>(y0) * width_; i < end; ++i) {
    develop_pixel(layer, i, &out.data()[i * out.channels()]);
  }
  if (layer == Layer::Variance) add_squared_bias(y0, y1, out);
}

void Film::add_squared_bias(int y0, int y1, Image& variance) const {
  if (!has_density_estimates()) return;
  const std::vector<float> squared_bias = density_.squared_bias(y0, y1);
  float* first = &variance.data()[static_cast<size_t>(y0) * width_];
  for (size_t i = 0; i < squared_bias.size(); ++i) first[i] += squared_bias[i];
}

Color Film::develop_pixel(Layer layer, int x, int y) const {
  Color color(0.0f);
  develop_pixel(layer, index(x, y), &color[0]);
  if (layer == Layer::Variance && has_density_estimates()) {
    color[0] += density_.squared_bias(y, y + 1)[x];
  }
  return color;
}

uint64_t Film::total_samples() const {
  uint64_t sum = 0;
  for (const Pixel& pixel : pixels_) sum += pixel.samples;
  return sum;
}

uint64_t Film::rejected() const {
  uint64_t sum = rejected_splats_;
  for (const Pixel& pixel : pixels_) sum += pixel.rejected;
  return sum;
}

double Film::estimated_relative_error() const {
  // Black pixels have no relative error; dark ones are kept from dominating by a floor at 1 % of
  // the picture's mean.
  double picture_mean = 0;
  size_t covered = 0;
  for (size_t i = 0; i < pixels_.size(); ++i) {
    const Estimates pixel = estimates(i);
    picture_mean += pixel.mean;
    if (pixel.count > 0) ++covered;
  }
  if (covered == 0 || picture_mean <= 0) return 0;
  picture_mean /= static_cast<double>(covered);
  std::vector<float> squared_bias(pixels_.size());
  if (has_density_estimates()) squared_bias = density_.squared_bias(0, height_);
  double sum = 0;
  for (size_t i = 0; i < pixels_.size(); ++i) {
    const Estimates pixel = estimates(i);
    const double error = std::sqrt(pixel.variance + squared_bias[i]);
    if (pixel.count > 1) sum += error / std::max(pixel.mean, 0.01 * picture_mean);
  }
  return sum / static_cast<double>(covered);
}

}  // namespace guidelight

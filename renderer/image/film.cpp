#include "renderer/image/film.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "renderer/error.h"

namespace guidelight {

const char* layer_name(Layer layer) {
  static constexpr const char* kNames[kLayerCount] = {
      "beauty", "direct", "indirect", "albedo", "normal", "depth", "sample_count", "variance"};
  return kNames[static_cast<size_t>(layer)];
}

int layer_channels(Layer layer) { return layer >= Layer::Depth ? 1 : 3; }

Film::Film(int width, int height, const FilterSettings& filter)
    : width_(width), height_(height), filter_(filter) {
  if (width <= 0 || height <= 0) {
    throw Error("a film of {}x{} pixels has nothing to show: give it at least one pixel", width,
                height);
  }
  pixels_.resize(static_cast<size_t>(width) * height);
}

void Film::add_sample(int x, int y, const FilmSample& sample) {
  Pixel& pixel = pixels_[index(x, y)];
  ++pixel.samples;
  const Color beauty = sample.direct + sample.indirect;
  if (!is_finite(beauty)) {
    ++pixel.rejected;
    return;
  }
  const double weight = sample.filter_weight;
  for (int c = 0; c < 3; ++c) {
    pixel.direct[c] += weight * sample.direct[c];
    pixel.indirect[c] += weight * sample.indirect[c];
    pixel.albedo[c] += weight * sample.albedo[c];
    pixel.normal[c] += weight * sample.normal[c];
  }
  if (sample.depth < kInfinity) {
    pixel.depth += sample.depth;
    ++pixel.hits;
  }
  pixel.luminance_squared += sqr(weight * luminance(beauty));
}

void Film::prepare_splats() {
  if (splats_.empty()) splats_.resize(3 * pixels_.size());
}

void Film::add_splat(Vec2 raster, Color contribution, Vec2 u) {
  // As a camera sample belongs to one pixel, so does a splat: the filter chooses which.
  const Filter::PixelChoice x = filter_.choose_pixel(raster.x, u.x);
  const Filter::PixelChoice y = filter_.choose_pixel(raster.y, u.y);
  if (x.pixel < 0 || y.pixel < 0 || x.pixel >= width_ || y.pixel >= height_) return;
  if (!is_finite(contribution)) return;
  double* sums = &splats_[3 * index(x.pixel, y.pixel)];
  const double weight = static_cast<double>(x.weight) * y.weight;
  for (int c = 0; c < 3; ++c) {
    std::atomic_ref(sums[c]).fetch_add(weight * contribution[c], std::memory_order_relaxed);
  }
}

void Film::merge(const Film& other) {
  if (other.width_ != width_ || other.height_ != height_) {
    throw Error("films of {}x{} and {}x{} pixels cannot be merged: render both at one size", width_,
                height_, other.width_, other.height_);
  }
  for (size_t i = 0; i < pixels_.size(); ++i) pixels_[i] += other.pixels_[i];
  if (!other.splats_.empty()) {
    prepare_splats();
    for (size_t i = 0; i < splats_.size(); ++i) splats_[i] += other.splats_[i];
  }
  splat_count_ += other.splat_count_;
}

void Film::clear() {
  std::fill(pixels_.begin(), pixels_.end(), Pixel{});
  std::fill(splats_.begin(), splats_.end(), 0.0);
  splat_count_ = 0;
}

Film::Pixel& Film::Pixel::operator+=(const Pixel& other) {
  for (int c = 0; c < 3; ++c) {
    direct[c] += other.direct[c];
    indirect[c] += other.indirect[c];
    albedo[c] += other.albedo[c];
    normal[c] += other.normal[c];
  }
  depth += other.depth;
  luminance_squared += other.luminance_squared;
  hits += other.hits;
  samples += other.samples;
  rejected += other.rejected;
  return *this;
}

namespace {

void store(float* out, const double (&sums)[3], double scale) {
  for (int c = 0; c < 3; ++c) out[c] = static_cast<float>(sums[c] * scale);
}

}  // namespace

double Film::mean_luminance(const Pixel& pixel) {
  const auto sum = [&](int c) { return pixel.direct[c] + pixel.indirect[c]; };
  return (0.2126 * sum(0) + 0.7152 * sum(1) + 0.0722 * sum(2)) / pixel.samples;
}

double Film::mean_variance(const Pixel& pixel) {
  if (pixel.samples < 2) return 0;
  const double n = pixel.samples;
  return std::max(0.0, pixel.luminance_squared / n - sqr(mean_luminance(pixel))) / (n - 1);
}

void Film::develop_pixel(Layer layer, size_t i, float* out) const {
  const Pixel& pixel = pixels_[i];
  const double scale = pixel.samples > 0 ? 1.0 / pixel.samples : 0.0;
  switch (layer) {
    case Layer::Beauty: {
      const double splat_scale =
          splat_count_ > 0 ? static_cast<double>(pixels_.size()) / splat_count_ : 0.0;
      for (int c = 0; c < 3; ++c) {
        double value = (pixel.direct[c] + pixel.indirect[c]) * scale;
        if (!splats_.empty()) value += splats_[3 * i + c] * splat_scale;
        out[c] = static_cast<float>(value);
      }
      break;
    }
    case Layer::Direct:
      store(out, pixel.direct, scale);
      break;
    case Layer::Indirect:
      store(out, pixel.indirect, scale);
      break;
    case Layer::Albedo:
      store(out, pixel.albedo, scale);
      break;
    case Layer::Normal:
      store(out, pixel.normal, scale);
      break;
    case Layer::Depth:
      out[0] = pixel.hits ? static_cast<float>(pixel.depth / pixel.hits) : 0;
      break;
    case Layer::SampleCount:
      out[0] = static_cast<float>(pixel.samples);
      break;
    case Layer::Variance:
      out[0] = static_cast<float>(mean_variance(pixel));
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
}

namespace {

constexpr size_t kPixelState = 17;  // numbers per pixel, as visit_state lists them
constexpr size_t kSplatState = 3;

}  // namespace

template <typename AnyPixel, typename Visit>
void Film::visit_state(AnyPixel& pixel, Visit&& visit) {
  for (auto* triple : {&pixel.direct, &pixel.indirect, &pixel.albedo, &pixel.normal}) {
    for (auto& value : *triple) visit(value);
  }
  visit(pixel.depth);
  visit(pixel.luminance_squared);
  visit(pixel.hits);
  visit(pixel.samples);
  visit(pixel.rejected);
}

std::vector<double> Film::state() const {
  std::vector<double> result;
  result.reserve(1 + kPixelState * pixels_.size() + splats_.size());
  result.push_back(static_cast<double>(splat_count_));
  for (const Pixel& pixel : pixels_) {
    visit_state(pixel, [&](auto value) { result.push_back(static_cast<double>(value)); });
  }
  result.insert(result.end(), splats_.begin(), splats_.end());
  return result;
}

void Film::restore(std::span<const double> state) {
  const size_t pixels = 1 + kPixelState * pixels_.size();
  if (state.size() != pixels && state.size() != pixels + kSplatState * pixels_.size()) {
    throw Error("the saved film does not have {}x{} pixels: resume at the size it was saved at",
                width_, height_);
  }
  const double* next = state.data();
  splat_count_ = static_cast<uint64_t>(*next++);
  for (Pixel& pixel : pixels_) {
    visit_state(pixel, [&](auto& value) {
      value = static_cast<std::remove_reference_t<decltype(value)>>(*next++);
    });
  }
  splats_.assign(next, state.data() + state.size());
}

uint64_t Film::total_samples() const {
  uint64_t sum = 0;
  for (const Pixel& pixel : pixels_) sum += pixel.samples;
  return sum;
}

uint64_t Film::rejected() const {
  uint64_t sum = 0;
  for (const Pixel& pixel : pixels_) sum += pixel.rejected;
  return sum;
}

double Film::estimated_relative_error() const {
  // Black pixels have no relative error; dark ones are kept from dominating by a floor at 1 % of
  // the picture's mean.
  double picture_mean = 0;
  size_t covered = 0;
  for (const Pixel& pixel : pixels_) {
    if (pixel.samples == 0) continue;
    picture_mean += mean_luminance(pixel);
    ++covered;
  }
  if (covered == 0 || picture_mean <= 0) return 0;
  picture_mean /= static_cast<double>(covered);
  double sum = 0;
  for (const Pixel& pixel : pixels_) {
    if (pixel.samples < 2) continue;
    sum += std::sqrt(mean_variance(pixel)) / std::max(mean_luminance(pixel), 0.01 * picture_mean);
  }
  return sum / static_cast<double>(covered);
}

}  // namespace guidelight

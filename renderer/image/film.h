#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "renderer/image/filter.h"
#include "renderer/image/image.h"

namespace guidelight {

/// The pictures a film develops. Colour layers have 3 channels, the others 1.
enum class Layer {
  Beauty,
  Direct,    // emitters seen directly and light after one scattering
  Indirect,  // the rest; beauty = direct + indirect
  Albedo,
  Normal,  // world space, -1..1, of the first hit
  Depth,   // distance from the camera along the ray [scene units], mean over samples that hit
  SampleCount,
  Variance,  // of the pixel mean, luminance of beauty
};
inline constexpr int kLayerCount = 8;
inline constexpr std::array<Layer, kLayerCount> kAllLayers = {
    Layer::Beauty, Layer::Direct, Layer::Indirect,    Layer::Albedo,
    Layer::Normal, Layer::Depth,  Layer::SampleCount, Layer::Variance};

/// Lower-case name for files and menus, e.g. "sample_count".
const char* layer_name(Layer layer);
int layer_channels(Layer layer);

/// What one camera sample saw. `weight` of the pixel filter multiplies all radiances.
struct FilmSample {
  Color direct{0.0f};
  Color indirect{0.0f};
  Color albedo{0.0f};
  Vec3 normal{0.0f};
  float depth = kInfinity;  // infinity: nothing was hit
  float filter_weight = 1;
};

/// Sums of samples per pixel in double precision, and of splats from light paths. Different pixels
/// may be written by different threads at once; splats may be added from anywhere.
class Film {
 public:
  Film(int width, int height, const FilterSettings& filter = {});

  int width() const { return width_; }
  int height() const { return height_; }
  const Filter& filter() const { return filter_; }

  /// A sample that is not finite counts as black, and in rejected().
  void add_sample(int x, int y, const FilmSample& sample);

  /// Must be called before the first splat, by one thread.
  void prepare_splats();
  /// Adds a light path's contribution to the picture at a raster position; u chooses the offset of
  /// the pixel filter. Thread safe. A film develops W·H/splat_count times the sum.
  void add_splat(Vec2 raster, Color contribution, Vec2 u);
  void add_splat_count(uint64_t light_paths) { splat_count_ += light_paths; }

  /// Adds another film of the same size. Throws Error if the sizes differ.
  void merge(const Film& other);
  void clear();

  Image develop(Layer layer) const;
  /// Rows [y0,y1) only, into an image of the film's size and the layer's channels.
  void develop_rows(Layer layer, int y0, int y1, Image& out) const;

  /// Everything the film has summed, for checkpoints; a film of the same size takes it back.
  /// restore() throws Error if the length does not fit.
  std::vector<double> state() const;
  void restore(std::span<const double> state);

  uint64_t total_samples() const;
  uint64_t rejected() const;
  /// Mean over the picture of each pixel's standard error over its mean (luminance): how noisy it
  /// is.
  double estimated_relative_error() const;

 private:
  struct Pixel {
    double direct[3] = {};
    double indirect[3] = {};
    double albedo[3] = {};
    double normal[3] = {};
    double depth = 0;
    double luminance_squared = 0;  // sum of Y²
    uint32_t hits = 0;             // samples with a depth
    uint32_t samples = 0;
    uint32_t rejected = 0;

    Pixel& operator+=(const Pixel& other);
  };

  size_t index(int x, int y) const { return static_cast<size_t>(y) * width_ + x; }
  static double mean_luminance(const Pixel& pixel);
  static double mean_variance(const Pixel& pixel);  // of the pixel's mean
  template <typename AnyPixel, typename Visit>
  static void visit_state(AnyPixel& pixel, Visit&& visit);
  void develop_pixel(Layer layer, size_t i, float* out) const;

  int width_;
  int height_;
  Filter filter_;
  std::vector<Pixel> pixels_;
  std::vector<double> splats_;  // 3 per pixel
  uint64_t splat_count_ = 0;
};

}  // namespace guidelight

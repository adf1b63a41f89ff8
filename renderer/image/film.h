#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "renderer/image/density_estimate.h"
#include "renderer/image/filter.h"
#include "renderer/image/image.h"
#include "renderer/image/layer.h"
#include "renderer/image/zeroed_array.h"

namespace guidelight {

/// What one camera sample saw: beauty is direct + indirect. `weight` of the pixel filter multiplies
/// all radiances.
struct FilmSample {
  Color direct{0.0f};
  Color indirect{0.0f};
  /// The part of `indirect` that went from the light by one or more specular bounces to a vertex
  /// that is not specular, and from there to the camera, directly or by specular bounces: L S⁺ D S*
  /// E in the notation of Heckbert (1990), D being whatever is not specular.
  Color caustic{0.0f};
  /// The part of direct + indirect that was found by merging vertices.
  Color merging{0.0f};
  Color albedo{0.0f};
  Vec3 normal{0.0f};
  float depth = kInfinity;  // infinity: nothing was hit
  /// Luminance by which direct + indirect is expected to be wrong, of a density estimate; counts in
  /// a film with density estimates.
  float bias = 0;
  float filter_weight = 1;
};

/// What a light path brought to the camera.
struct Splat {
  Vec2 raster{0.0f};
  Color contribution{0.0f};
  bool direct = false;   // else indirect
  bool caustic = false;  // as FilmSample::caustic; never together with direct
};

/// Sums of samples per pixel in double precision, and of splats from light paths. Different pixels
/// may be written by different threads at once; splats may be added from anywhere.
///
/// The samples of a pixel are independent, and their variance is known without further ado. Splats
/// of one pass are not, so a film with splats takes the variance between passes.
class Film {
 public:
  Film(int width, int height, const FilterSettings& filter = {});

  int width() const { return width_; }
  int height() const { return height_; }
  const Filter& filter() const { return filter_; }

  /// A sample that is not finite counts as black, and in rejected().
  void add_sample(int x, int y, const FilmSample& sample);

  /// Must be called before the first splat, and before the samples of its pass, by one thread.
  void prepare_splats();
  /// Adds what a light path contributes to the picture; u chooses the offset of the pixel filter.
  /// A film develops W·H/splat_count times the sum. A splat that is not finite counts in
  /// rejected() only. Thread safe.
  void add_splat(const Splat& splat, Vec2 u) { add_splats({&splat, 1}, {&u, 1}); }
  /// Many at once are faster: they wait for memory together. `u` has the size of `splats`.
  void add_splats(std::span<const Splat> splats, std::span<const Vec2> u);
  /// To be called with every batch of light paths, whether they brought splats or not, so that a
  /// pass that is given up leaves the right picture. Thread safe.
  void add_splat_count(uint64_t light_paths);

  /// Gives every pixel `per_pixel` density estimates, for methods whose next pass depends on what
  /// they have found so far: the film keeps the statistics, so that they are saved, resumed and
  /// merged with the picture. Does nothing to a film that has them; throws Error if it has another
  /// number of them. To be called by one thread.
  void prepare_density_estimates(int per_pixel);
  /// Those of a pixel; empty without.
  std::span<DensityEstimate> density_estimates(int x, int y);
  std::span<const DensityEstimate> density_estimates(int x, int y) const;

  /// Ends a pass: only whole passes count for the variance of a film with splats. Nothing to do for
  /// a film without.
  void finish_pass();

  /// Adds another film of the same size, of which an unfinished pass does not count for the
  /// variance. Throws Error if the sizes differ.
  void merge(const Film& other);
  void clear();

  Image develop(Layer layer) const;
  /// Rows [y0,y1) only, into an image of the film's size and the layer's channels.
  void develop_rows(Layer layer, int y0, int y1, Image& out) const;
  /// A layer at one pixel; of layers with one channel the first counts.
  Color develop_pixel(Layer layer, int x, int y) const;

  /// Everything the film has summed, for checkpoints; a film of the same size takes it back.
  /// restore() throws Error if the length does not fit.
  std::vector<double> state() const;
  void restore(std::span<const double> state);

  uint64_t total_samples() const;
  uint64_t rejected() const;
  /// Mean over the picture of each pixel's standard error over its mean (luminance): how noisy it
  /// is. Of density estimates, the bias is part of the error.
  double estimated_relative_error() const;

 private:
  struct SplatTarget {
    size_t pixel;
    double weight;  // 0: outside the picture
  };
  SplatTarget splat_target(Vec2 raster, Vec2 u) const;
  void add_splat_at(const SplatTarget& target, const Splat& splat);

  struct Radiance {
    double direct[3] = {};
    double indirect[3] = {};
    double caustic[3] = {};
    double merging[3] = {};  // of splats 0: they are connections with the lens
  };
  struct Pixel {
    Radiance radiance;
    double albedo[3] = {};
    double normal[3] = {};
    double depth = 0;
    double luminance_squared = 0;  // sum of Y²
    uint32_t hits = 0;             // samples with a depth
    uint32_t samples = 0;
    uint32_t rejected = 0;
  };
  /// Luminance of the passes of a film with splats.
  struct PassStatistics {
    double sum = 0;      // of the estimates of finished passes
    double squares = 0;  // of the same
    // Of the pass under way.
    float sample_sum = 0;
    float splat_sum = 0;
    uint32_t samples = 0;
  };
  /// Independent estimates of a pixel's luminance.
  struct Estimates {
    uint64_t count = 0;
    double mean = 0;
    double variance = 0;  // of the mean
  };

  size_t index(int x, int y) const { return static_cast<size_t>(y) * width_ + x; }
  bool has_splats() const { return !splats_.empty(); }
  bool has_density_estimates() const { return density_.per_pixel() > 0; }
  double splat_scale(uint64_t light_paths) const;
  Estimates estimates(size_t i) const;
  // Call visit(a.x, b.x, …) for every number x of the state: what is saved and merged.
  template <typename Visit, typename... Radiances>
  static void visit_radiance(Visit&& visit, Radiances&... radiance);
  template <typename Visit, typename... Pixels>
  static void visit_pixel(Visit&& visit, Pixels&... pixel);
  template <typename Visit, typename... Films>
  static void visit_splats(Visit&& visit, size_t i, Films&... film);
  void develop_pixel(Layer layer, size_t i, float* out) const;
  void add_squared_bias(int y0, int y1, Image& variance) const;

  int width_;
  int height_;
  Filter filter_;
  ZeroedArray<Pixel> pixels_;
  ZeroedArray<Radiance> splats_;            // per pixel, or empty
  ZeroedArray<PassStatistics> statistics_;  // as many as splats
  DensityEstimates density_;
  uint64_t splat_count_ = 0;           // light paths
  uint64_t finished_splat_count_ = 0;  // of finished passes
  uint64_t finished_passes_ = 0;       // of a film with splats
  uint64_t rejected_splats_ = 0;
};

}  // namespace guidelight

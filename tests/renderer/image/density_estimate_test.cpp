#include "renderer/image/density_estimate.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "renderer/error.h"
#include "renderer/image/film.h"
#include "renderer/sampling/random.h"

namespace guidelight {
namespace {

DensityEstimate estimate_of_radius(float radius) { return {.radius_squared = sqr(radius)}; }

TEST(DensityEstimate, follows_the_equations_of_the_source) {
  // N = 3, R = 2, τ = 10; ten photons with τ_M = 5 and α = 0.7: N' = 10 and everything is scaled by
  // 10/13.
  DensityEstimate estimate{100, 3, 4, Color(10)};
  estimate.add_pass(50, 10, Color(5), 0.7f);
  EXPECT_DOUBLE_EQ(estimate.emitted, 150);
  EXPECT_FLOAT_EQ(estimate.count, 10);
  EXPECT_FLOAT_EQ(estimate.radius_squared, 4.0f * 10 / 13);
  EXPECT_FLOAT_EQ(estimate.flux.r, 15.0f * 10 / 13);
  EXPECT_FLOAT_EQ(estimate.radiance().r, 15.0f / (kPi * 4 * 150));
}

TEST(DensityEstimate, does_not_shrink_where_nothing_is_found) {
  DensityEstimate estimate = estimate_of_radius(2);
  estimate.add_pass(50, 0, Color(0), 0.7f);
  EXPECT_EQ(estimate.radius_squared, 4);
  EXPECT_EQ(estimate.radiance(), Color(0));
  EXPECT_EQ(DensityEstimate{}.radiance(), Color(0));
}

/// Adds passes that find what a random pass may find; returns the mean of their own estimates.
float add_random_passes(DensityEstimate& estimate, int passes, uint64_t seed) {
  constexpr double kPaths = 1000;
  Rng rng(seed, 0, 0);
  double sum = 0;
  for (int i = 0; i < passes; ++i) {
    const int found = static_cast<int>(rng.next_float() * 4);
    const float flux = static_cast<float>(found) * rng.next_float();
    sum += flux / (kPi * estimate.radius_squared * kPaths);
    estimate.add_pass(kPaths, found, Color(flux), 2.0f / 3);
  }
  return static_cast<float>(sum / passes);
}

TEST(DensityEstimate, is_the_mean_of_the_passes_each_with_its_radius) {
  DensityEstimate estimate = estimate_of_radius(0.5f);
  const float mean = add_random_passes(estimate, 1000, 1);
  EXPECT_NEAR(estimate.radiance().g, mean, 1e-4f * mean);
  EXPECT_LT(estimate.radius_squared, 0.25f * 0.2f);
}

TEST(DensityEstimate, radius_shrinks_as_predicted_where_photons_are_evenly_spread) {
  // M ∝ R² gives R² ∝ i^(α-1) in the limit (Knaus and Zwicker 2011).
  DensityEstimate estimate = estimate_of_radius(1);
  const auto shrink_to = [&](int begin, int end) {
    for (int i = begin; i < end; ++i) {
      estimate.add_pass(1, static_cast<int>(1e5f * estimate.radius_squared), Color(1), 0.5f);
    }
    return estimate.radius_squared;
  };
  const float after_100 = shrink_to(0, 100);
  EXPECT_NEAR(shrink_to(100, 10000) / after_100, std::sqrt(0.01f), 0.003f);
}

TEST(DensityEstimate, merges_to_the_mean_picture) {
  DensityEstimate a = estimate_of_radius(0.5f);
  DensityEstimate b = estimate_of_radius(0.5f);
  const float mean_a = add_random_passes(a, 300, 1);
  const float mean_b = add_random_passes(b, 100, 2);
  DensityEstimate both;
  both.merge(a);
  EXPECT_EQ(both.radius_squared, a.radius_squared);
  EXPECT_EQ(both.flux, a.flux);
  both.merge(b);
  EXPECT_FLOAT_EQ(both.count, a.count + b.count);
  const float mean = 0.75f * mean_a + 0.25f * mean_b;
  EXPECT_NEAR(both.radiance().r, mean, 1e-4f * mean);
}

TEST(DensityEstimates, squared_bias_is_right_in_the_mean) {
  // Bias samples of mean ±0.5 in the two halves of the picture, of standard deviation 2: of one
  // pixel the bias cannot be seen, but of a block it can.
  DensityEstimates estimates(128, 64, 1);
  for (size_t pixel = 0; pixel < size_t{128} * 64; ++pixel) {
    Rng rng(1, 0, pixel);
    const double bias = pixel % 128 < 64 ? 0.5 : 0;
    for (int i = 0; i < 16; ++i) {
      estimates.add_bias(pixel, bias + 2 * std::sqrt(12.0) * (rng.next_float() - 0.5));
    }
  }
  const std::vector<float> squared = estimates.squared_bias(0, 64);
  double left = 0, right = 0;
  for (size_t i = 0; i < squared.size(); ++i) (i % 128 < 64 ? left : right) += squared[i] / 4096;
  // A mean of 16 has the variance 1/4; the mean of 4096 such squares has a standard error of 0.007.
  EXPECT_NEAR(left, 0.25, 0.035);
  EXPECT_LT(right, 0.05);  // the blocks' noise, of which the negative half is cut off
  const std::vector<float> rows = estimates.squared_bias(13, 30);
  for (size_t i = 0; i < rows.size(); ++i) EXPECT_EQ(rows[i], squared[13 * 128 + i]);
}

Film film_with_density_estimates() {
  Film film(3, 2);
  film.prepare_density_estimates(2);
  for (int pass = 0; pass < 4; ++pass) {
    for (int i = 0; i < 6; ++i) {
      FilmSample sample;
      sample.indirect = Color(static_cast<float>(i + pass));
      sample.bias = 0.1f * static_cast<float>(i);
      film.add_sample(i % 3, i / 3, sample);
      for (DensityEstimate& estimate : film.density_estimates(i % 3, i / 3)) {
        if (pass == 0) estimate.radius_squared = 0.25f;
        estimate.add_pass(10, i, Color(1, 2, 3), 0.7f);
      }
    }
  }
  return film;
}

void expect_equal(const Film& a, const Film& b) {
  for (const Layer layer : kAllLayers) {
    EXPECT_TRUE(std::ranges::equal(a.develop(layer).data(), b.develop(layer).data()));
  }
  EXPECT_EQ(a.state(), b.state());
}

TEST(Film, keeps_density_estimates_when_saved_and_merged) {
  const Film film = film_with_density_estimates();
  Film restored(3, 2);
  restored.restore(film.state());
  expect_equal(restored, film);
  Film merged(3, 2);
  merged.merge(film);
  expect_equal(merged, film);
  merged.clear();
  EXPECT_TRUE(merged.density_estimates(0, 0).empty());
}

TEST(Film, bias_is_part_of_the_error_of_density_estimates) {
  const Film film = film_with_density_estimates();
  // Samples 0..3 and a constant bias: variance 5/12, and the mean of the squared biases.
  const float squared_bias = 0.01f * (1 + 4 + 9 + 16 + 25) / 6;
  EXPECT_NEAR(film.develop_pixel(Layer::Variance, 0, 0)[0], 5.0f / 12 + squared_bias, 1e-5f);
  EXPECT_EQ(film.develop_pixel(Layer::Variance, 2, 1)[0],
            *film.develop(Layer::Variance).pixel(2, 1));
}

TEST(Film, insists_on_the_number_of_density_estimates) {
  Film film(1, 1);
  film.prepare_density_estimates(4);
  EXPECT_NO_THROW(film.prepare_density_estimates(4));
  EXPECT_THROW(film.prepare_density_estimates(1), Error);
}

}  // namespace
}  // namespace guidelight

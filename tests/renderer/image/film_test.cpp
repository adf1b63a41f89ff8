#include "renderer/image/film.h"

#include <gtest/gtest.h>

#include <thread>

#include "renderer/error.h"

namespace guidelight {
namespace {

FilmSample sample(float direct, float indirect = 0) {
  FilmSample result;
  result.direct = Color(direct);
  result.indirect = Color(indirect);
  return result;
}

TEST(Film, averages_samples_and_tells_the_variance_of_the_mean) {
  Film film(2, 1);
  for (const float value : {1.0f, 2.0f, 3.0f, 6.0f}) film.add_sample(1, 0, sample(value, 1));
  EXPECT_FLOAT_EQ(film.develop(Layer::Beauty).color(1, 0).g, 4);
  EXPECT_FLOAT_EQ(film.develop(Layer::Direct).color(1, 0).g, 3);
  EXPECT_FLOAT_EQ(film.develop(Layer::Indirect).color(1, 0).g, 1);
  EXPECT_EQ(film.develop(Layer::Beauty).color(0, 0), Color(0));
  EXPECT_FLOAT_EQ(*film.develop(Layer::SampleCount).pixel(1, 0), 4);
  // Sample variance of {2,3,4,7} is 14/3; of the mean of four, 14/12.
  EXPECT_NEAR(*film.develop(Layer::Variance).pixel(1, 0), 14.0 / 12, 1e-5);
}

TEST(Film, depth_averages_only_samples_that_hit) {
  Film film(1, 1);
  FilmSample hit = sample(1);
  hit.depth = 3;
  film.add_sample(0, 0, hit);
  film.add_sample(0, 0, sample(1));
  EXPECT_FLOAT_EQ(*film.develop(Layer::Depth).pixel(0, 0), 3);
}

TEST(Film, counts_samples_that_are_not_finite_as_black) {
  Film film(1, 1);
  film.add_sample(0, 0, sample(std::nanf("")));
  film.add_sample(0, 0, sample(kInfinity));
  film.add_sample(0, 0, sample(3));
  EXPECT_EQ(film.rejected(), 2u);
  EXPECT_FLOAT_EQ(film.develop(Layer::Beauty).color(0, 0).r, 1);
}

TEST(Film, merged_parts_equal_the_whole) {
  Film whole(3, 2), first(3, 2), second(3, 2);
  whole.prepare_splats();
  second.prepare_splats();
  for (int i = 0; i < 60; ++i) {
    const FilmSample s = sample(0.1f * i, 0.5f);
    (i % 2 ? first : second).add_sample(i % 3, i / 3 % 2, s);
    whole.add_sample(i % 3, i / 3 % 2, s);
  }
  for (Film* film : {&whole, &second}) {
    film->add_splat({1.5f, 0.5f}, Color(2), {0.5f, 0.5f});
    film->add_splat_count(4);
  }
  first.merge(second);
  for (const Layer layer : kAllLayers) {
    const Image a = whole.develop(layer), b = first.develop(layer);
    for (size_t i = 0; i < a.data().size(); ++i) EXPECT_NEAR(a.data()[i], b.data()[i], 1e-5f);
  }
  EXPECT_THROW(first.merge(Film(2, 3)), Error);
}

TEST(Film, splats_from_many_threads_are_all_there) {
  Film film(4, 4, {FilterKind::Box});
  film.prepare_splats();
  constexpr int kSplats = 20000;
  const auto splat = [&] {
    for (int i = 0; i < kSplats; ++i) film.add_splat({1.5f, 2.5f}, Color(1), {0.5f, 0.5f});
  };
  std::thread other(splat);
  splat();
  other.join();
  film.add_splat_count(16);  // one light path per pixel: the scale is 1
  EXPECT_FLOAT_EQ(film.develop(Layer::Beauty).color(1, 2).r, 2 * kSplats);
}

TEST(Film, a_splat_is_spread_by_the_pixel_filter) {
  // Over uniform u, a splat at distance (dx, dy) from a pixel's centre reaches it with weight f(dx,
  // dy), just as a camera sample there would count for that pixel.
  for (const FilterKind kind :
       {FilterKind::Box, FilterKind::Tent, FilterKind::Gaussian, FilterKind::Mitchell}) {
    const Filter filter({kind});
    Film film(9, 9, filter.settings());
    film.prepare_splats();
    constexpr int kSide = 256;
    for (int i = 0; i < kSide; ++i) {
      for (int j = 0; j < kSide; ++j) {
        const Vec2 u((i + 0.5f) / kSide, (j + 0.5f) / kSide);
        film.add_splat({4.2f, 4.6f}, Color(1.0f / (kSide * kSide)), u);
      }
    }
    film.add_splat_count(81);
    const Image image = film.develop(Layer::Beauty);
    for (int y = 0; y < 9; ++y) {
      for (int x = 0; x < 9; ++x) {
        const Vec2 offset = Vec2(4.2f, 4.6f) - Vec2(x + 0.5f, y + 0.5f);
        EXPECT_NEAR(image.color(x, y).r, filter.eval(offset), 0.01) << x << " " << y;
      }
    }
  }
}

TEST(Film, state_survives_a_round_trip) {
  Film film(3, 2);
  film.prepare_splats();
  FilmSample s = sample(1, 2);
  s.albedo = Color(0.5f);
  s.normal = {0, 1, 0};
  s.depth = 4;
  film.add_sample(2, 1, s);
  film.add_splat({0.5f, 0.5f}, Color(3), {0.5f, 0.5f});
  film.add_splat_count(6);
  Film copy(3, 2);
  copy.restore(film.state());
  EXPECT_EQ(copy.state(), film.state());
  EXPECT_THROW(Film(2, 2).restore(film.state()), Error);
}

TEST(Film, rejects_an_empty_size) { EXPECT_THROW(Film(0, 4), Error); }

}  // namespace
}  // namespace guidelight

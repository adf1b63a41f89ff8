#include "renderer/image/film.h"

#include <gtest/gtest.h>

#include <map>
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

TEST(Film, more_pixels_than_memory_are_an_error_with_a_remedy) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the address sanitizer ends the program where malloc returns nothing";
#endif
  try {
    Film(2000000000, 2000000000);
    FAIL() << "four exapixels fit into memory";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("render fewer pixels"), std::string::npos);
  }
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

/// A pass of one sample and one light path per pixel, different each time.
void add_pass(Film& film, int pass, bool splats) {
  if (splats) film.prepare_splats();
  for (int i = 0; i < film.width() * film.height(); ++i) {
    const int x = i % film.width(), y = i / film.width();
    FilmSample s = sample(0.1f * static_cast<float>(i + pass % 5), 0.5f);
    s.caustic = Color(0.2f);
    s.merging = Color(0.1f * static_cast<float>(pass % 3));
    film.add_sample(x, y, s);
    if (!splats) continue;
    const auto strength = static_cast<float>(1 + (i * pass) % 7);
    film.add_splat({Vec2(x, y) + 0.5f, Color(strength, 1, 2), i % 3 == 0, i % 3 == 1}, Vec2(0.5f));
    film.add_splat_count(1);
  }
}

void expect_equal_pictures(const Film& a, const Film& b) {
  for (const Layer layer : kAllLayers) {
    const Image first = a.develop(layer), second = b.develop(layer);
    for (size_t i = 0; i < first.data().size(); ++i) {
      EXPECT_NEAR(first.data()[i], second.data()[i], 1e-5f) << layer_name(layer);
    }
  }
  EXPECT_NEAR(a.estimated_relative_error(), b.estimated_relative_error(), 1e-6);
  EXPECT_EQ(a.rejected(), b.rejected());
}

TEST(Film, merged_parts_equal_the_whole) {
  for (const bool splats : {false, true}) {
    Film whole(3, 2), first(3, 2), second(3, 2);
    for (int pass = 0; pass < 10; ++pass) {
      for (Film* film : {&whole, pass % 3 ? &first : &second}) {
        add_pass(*film, pass, splats);
        film->finish_pass();
      }
    }
    EXPECT_GT(whole.estimated_relative_error(), 0);
    first.merge(second);
    expect_equal_pictures(first, whole);
    EXPECT_THROW(first.merge(Film(2, 3)), Error);
  }
}

TEST(Film, splats_belong_to_their_layers) {
  Film film(2, 1, {FilterKind::Box});
  film.prepare_splats();
  FilmSample s = sample(1, 2);
  s.caustic = Color(0.5f);
  s.merging = Color(2.5f);
  film.add_sample(0, 0, s);
  const auto splat = [&](float strength, bool direct, bool caustic) {
    film.add_splat({{0.5f, 0.5f}, Color(strength), direct, caustic}, Vec2(0.5f));
  };
  splat(10, true, false);
  splat(20, false, false);
  splat(40, false, true);
  film.add_splat_count(4);  // two light paths per pixel: splats count half
  const std::map<Layer, float> expected = {{Layer::Beauty, 38},    {Layer::Direct, 6},
                                           {Layer::Indirect, 32},  {Layer::Caustic, 20.5f},
                                           {Layer::Merging, 2.5f}, {Layer::Connection, 35.5f}};
  for (const auto& [layer, value] : expected) {
    EXPECT_FLOAT_EQ(film.develop(layer).color(0, 0).r, value) << layer_name(layer);
    EXPECT_EQ(film.develop(layer).color(1, 0), Color(0)) << layer_name(layer);
  }
}

TEST(Film, splats_that_are_not_finite_are_left_out_and_counted) {
  Film film(1, 1);
  film.prepare_splats();
  film.add_splat({{0.5f, 0.5f}, Color(std::nanf(""))}, Vec2(0.5f));
  film.add_splat({{0.5f, 0.5f}, Color(0, kInfinity, 0)}, Vec2(0.5f));
  film.add_splat_count(2);
  EXPECT_EQ(film.develop(Layer::Beauty).color(0, 0), Color(0));
  EXPECT_EQ(film.rejected(), 2u);
}

TEST(Film, with_splats_tells_the_variance_between_passes) {
  Film film(1, 1, {FilterKind::Box});
  film.prepare_splats();
  // Passes of 1, 2, 3 and 6 samples' and splats' luminance together, with several light paths.
  for (const float value : {1.0f, 2.0f, 3.0f, 6.0f}) {
    film.add_sample(0, 0, sample(0.25f * value, 0.5f));
    film.add_sample(0, 0, sample(0.25f * value, 0.5f));
    for (int i = 0; i < 5; ++i) film.add_splat({{0.5f, 0.5f}, Color(0.75f * value)}, Vec2(0.5f));
    film.add_splat_count(5);
    film.finish_pass();
  }
  const auto variance = [&] { return *film.develop(Layer::Variance).pixel(0, 0); };
  EXPECT_FLOAT_EQ(film.develop(Layer::Beauty).color(0, 0).g, 3.5f);
  EXPECT_NEAR(variance(), 14.0 / 12, 1e-5);  // as in the first test
  EXPECT_NEAR(film.estimated_relative_error(), std::sqrt(14.0 / 12) / 3.5, 1e-5);

  // A pass that is given up is seen in the picture, and leaves the variance as it was.
  film.add_splat({{0.5f, 0.5f}, Color(100)}, Vec2(0.5f));
  film.add_splat_count(1);
  EXPECT_NEAR(film.develop(Layer::Beauty).color(0, 0).g, 1.25 + (5 * 9 + 100) / 21.0, 1e-5);
  EXPECT_NEAR(variance(), 14.0 / 12, 1e-5);
  // Nor does it come back in the next pass of a film that was saved and resumed.
  Film resumed(1, 1, {FilterKind::Box});
  resumed.restore(film.state());
  film = Film(1, 1, {FilterKind::Box});
  film.merge(resumed);
  for (Film* each : {&resumed, &film}) {
    each->add_sample(0, 0, sample(3, 0.5f));
    each->add_splat_count(5);
    each->finish_pass();
    // {1,2,3,6} + 0.5 and 3.5: Σ(x-x̄)² stays 14.
    EXPECT_NEAR(*each->develop(Layer::Variance).pixel(0, 0), 14.0 / (4 * 5), 1e-5);
  }
}

TEST(Film, both_variances_agree) {
  // The same independent values, once as samples and once as passes of a film with splats.
  Film samples(3, 2), passes(3, 2);
  passes.prepare_splats();
  for (int pass = 0; pass < 20; ++pass) {
    add_pass(samples, pass, false);
    add_pass(passes, pass, false);
    passes.finish_pass();
  }
  expect_equal_pictures(samples, passes);
}

TEST(Film, splats_from_many_threads_are_all_there) {
  Film film(4, 4, {FilterKind::Box});
  film.prepare_splats();
  constexpr int kSplats = 20000;
  const auto splat = [&] {
    for (int i = 0; i < kSplats; ++i) {
      film.add_splat({{1.5f, 2.5f}, Color(1), false, true}, Vec2(0.5f));
      film.add_splat({{1.5f, 2.5f}, Color(kInfinity)}, Vec2(0.5f));
      film.add_splat_count(8);
    }
  };
  std::thread other(splat);
  splat();
  other.join();
  for (const Layer layer : {Layer::Beauty, Layer::Caustic}) {
    EXPECT_FLOAT_EQ(film.develop(layer).color(1, 2).r, 2);  // each light path counts for 1/16
  }
  EXPECT_EQ(film.rejected(), 2u * kSplats);
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
        film.add_splat({{4.2f, 4.6f}, Color(1.0f / (kSide * kSide))}, u);
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
  for (const bool splats : {false, true}) {
    Film film(3, 2);
    for (int pass = 0; pass < 4; ++pass) {
      add_pass(film, pass, splats);
      film.finish_pass();
    }
    FilmSample s = sample(1, 2);
    s.albedo = Color(0.5f);
    s.normal = {0, 1, 0};
    s.depth = 4;
    film.add_sample(2, 1, s);
    film.add_sample(2, 1, sample(kInfinity));
    Film copy(3, 2);
    copy.restore(film.state());
    EXPECT_EQ(copy.state(), film.state());
    expect_equal_pictures(copy, film);
    copy.clear();
    EXPECT_EQ(copy.total_samples(), 0u);
    EXPECT_THROW(Film(2, 2).restore(film.state()), Error);
  }
}

TEST(Film, rejects_an_empty_size) { EXPECT_THROW(Film(0, 4), Error); }

}  // namespace
}  // namespace guidelight

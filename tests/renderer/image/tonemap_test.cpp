#include "renderer/image/tonemap.h"

#include <gtest/gtest.h>

#include "renderer/sampling/random.h"

namespace guidelight {
namespace {

DisplaySettings with_curve(ToneCurve curve) {
  DisplaySettings settings;
  settings.curve = curve;
  return settings;
}

TEST(ToneMap, SrgbHasItsPublishedValues) {
  const DisplaySettings srgb;
  EXPECT_NEAR(display_color(Color(0.214041f), srgb).r, 0.5f, 1e-5f);
  EXPECT_NEAR(display_color(Color(0.001f), srgb).r, 0.01292f, 1e-6f);
  EXPECT_FLOAT_EQ(display_color(Color(7), srgb).g, 1);
  EXPECT_EQ(display_color(Color(-1), srgb), Color(0));
}

TEST(ToneMap, ExposureDoublesPerStop) {
  DisplaySettings gamma = with_curve(ToneCurve::Gamma);
  gamma.gamma = 1;
  gamma.exposure = 3;
  EXPECT_NEAR(display_color(Color(0.1f, 0.05f, 0), gamma).r, 0.8f, 1e-6f);
}

TEST(ToneMap, ReinhardShowsWhiteLuminanceAsWhite) {
  DisplaySettings reinhard = with_curve(ToneCurve::Reinhard);
  reinhard.reinhard_white = 4;
  EXPECT_NEAR(display_color(Color(4), reinhard).g, 1, 1e-5f);
  EXPECT_LT(display_color(Color(3.9f), reinhard).g, 1);
  // L(1 + L/16)/(1 + L) at L = 1 is 0.53125.
  DisplaySettings linear = with_curve(ToneCurve::Srgb);
  EXPECT_NEAR(display_color(Color(1), reinhard).g, display_color(Color(0.53125f), linear).g, 1e-5f);
}

TEST(ToneMap, FilmicRisesFromBlackToWhite) {
  const DisplaySettings filmic = with_curve(ToneCurve::Filmic);
  EXPECT_EQ(display_color(Color(0), filmic), Color(0));
  float last = 0;
  for (float x = 0.01f; x < 10; x *= 1.5f) {
    const float y = display_color(Color(x), filmic).r;
    EXPECT_GE(y, last);
    last = y;
  }
  EXPECT_FLOAT_EQ(last, 1);
}

TEST(ToneMap, FalseColorIsLogarithmic) {
  DisplaySettings settings = with_curve(ToneCurve::FalseColor);
  settings.false_color_min = 0.01f;
  settings.false_color_max = 1;
  for (const ColorMap map : {ColorMap::Viridis, ColorMap::Turbo, ColorMap::Magma}) {
    settings.color_map = map;
    const auto near = [](Color a, Color b) { return glm::length(a - b) < 1e-4f; };
    EXPECT_TRUE(near(display_color(Color(0.1f), settings), color_map(map, 0.5f)));
    EXPECT_TRUE(near(display_color(Color(0), settings), color_map(map, 0)));
    EXPECT_TRUE(near(display_color(Color(50), settings), color_map(map, 1)));
  }
  EXPECT_NEAR(color_map(ColorMap::Viridis, 0.5f).g, 0.5636f, 0.01f);
}

TEST(ToneMap, ClippedAndBrokenPixelsAreMarked) {
  DisplaySettings settings;
  settings.show_clipped = true;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(display_color(Color(0.5f, 1.01f, 0), settings), Color(1, 0, 0));
  EXPECT_EQ(display_color(Color(0, nan, 0), settings), Color(1, 0, 1));
  EXPECT_EQ(display_color(Color(kInfinity), settings), Color(1, 0, 1));
  settings.show_clipped = false;
  EXPECT_EQ(display_color(Color(nan), settings), Color(0));
  EXPECT_FLOAT_EQ(display_color(Color(kInfinity), settings).r, 1);
}

TEST(ToneMap, PicturesAgreeWithSinglePixels) {
  Image image(61, 17, 3);
  Rng rng(1, 0, 0);
  for (float& v : image.data()) v = std::exp(12 * rng.next_float() - 9);
  image.pixel(3, 3)[1] = std::numeric_limits<float>::quiet_NaN();
  image.pixel(4, 3)[0] = kInfinity;
  for (const ToneCurve curve : {ToneCurve::Srgb, ToneCurve::Gamma, ToneCurve::Reinhard,
                                ToneCurve::Filmic, ToneCurve::FalseColor}) {
    for (const bool show_clipped : {false, true}) {
      DisplaySettings settings = with_curve(curve);
      settings.exposure = 0.7f;
      settings.show_clipped = show_clipped;
      DisplayImage out;
      display_image(image, settings, out);
      ASSERT_EQ(out.rgba.size(), 4 * image.pixel_count());
      for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
          const Color exact = 255.0f * display_color(image.color(x, y), settings);
          const uint8_t* bytes = &out.rgba[4 * (static_cast<size_t>(y) * image.width() + x)];
          // Half a step of rounding, and what the tables may add.
          for (int c = 0; c < 3; ++c) ASSERT_NEAR(bytes[c], exact[c], 1.0f) << int(curve);
          ASSERT_EQ(bytes[3], 255);
        }
      }
    }
  }
}

TEST(ToneMap, AutoExposurePutsTheLogAverageAtMiddleGrey) {
  Image image(2, 2, 1);
  image.pixel(0, 0)[0] = 0.02f;
  image.pixel(1, 0)[0] = 2;  // log average 0.2
  image.pixel(0, 1)[0] = 0;
  image.pixel(1, 1)[0] = kInfinity;
  EXPECT_NEAR(0.2f * std::exp2(auto_exposure(image)), 0.18f, 1e-5f);
  EXPECT_EQ(auto_exposure(Image(2, 2, 3)), 0);
}

}  // namespace
}  // namespace guidelight

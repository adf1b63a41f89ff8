#include "renderer/photons/photon.h"

#include <gtest/gtest.h>

#include "renderer/sampling/warp.h"
#include "tests/statistics/hypothesis_tests.h"

namespace guidelight {
namespace {

using statistics::Moments;

float largest_error(Color a, Color b) {
  const Color difference = glm::abs(a - b);
  return max_component(difference);
}

/// Colours over many magnitudes; every third is grey, every third saturated.
Color random_color(Rng& rng, int i) {
  const float scale = std::exp2(80 * rng.next_float() - 40);
  if (i % 3 == 0) return Color(scale);
  Color c(rng.next_float(), rng.next_float(), rng.next_float());
  if (i % 3 == 1) c = c * c * c;
  return scale * c;
}

TEST(Photon, keeps_what_it_was_made_from) {
  Rng rng(1, 0, 0);
  for (int i = 0; i < 100000; ++i) {
    const Vec3 wi = square_to_sphere(rng.next_vec2());
    const Vec3 position(rng.next_float(), rng.next_float(), rng.next_float());
    const int length = i % 130;
    const Photon photon =
        make_photon(position, wi, Color(1, 2, 3), length, i % 2 == 0, {1.5f, 2.5f, 3.5f});
    EXPECT_EQ(photon.position, position);
    EXPECT_NEAR(glm::length(photon.direction()), 1, 1e-6f);
    EXPECT_LT(glm::length(photon.direction() - wi), 1.1e-3f);
    EXPECT_EQ(photon.length(), std::min(length, 127));
    EXPECT_EQ(photon.caustic(), i % 2 == 0);
    EXPECT_EQ(photon.partials.inverse_pdf, 1.5f);
    EXPECT_EQ(photon.partials.connection, 2.5f);
    EXPECT_EQ(photon.partials.merging, 3.5f);
  }
}

TEST(Photon, directions_along_the_axes_are_exact) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const float sign : {-1.0f, 1.0f}) {
      Vec3 w(0);
      w[axis] = sign;
      EXPECT_EQ(unpack_direction(pack_direction(w)), w);
    }
  }
}

TEST(Photon, colours_are_as_near_as_promised) {
  Rng rng(2, 0, 0);
  for (int i = 0; i < 300000; ++i) {
    const Color color = random_color(rng, i);
    const Color unpacked = unpack_color(pack_color(color, mix_bits(i)));
    const float largest = max_component(color);
    EXPECT_LE(std::abs(max_component(unpacked) - largest), largest * 0x1p-9f);
    // Of the other channels: one step of the ratio, and the error of the largest.
    EXPECT_LE(largest_error(unpacked, color), largest * (1.0f / 127 + 0x1p-9f));
  }
}

TEST(Photon, white_stays_white) {
  for (int i = 0; i < 1000; ++i) {
    const Color c = unpack_color(pack_color(Color(0.1f), mix_bits(i)));
    EXPECT_EQ(c.r, c.g);
    EXPECT_EQ(c.g, c.b);
  }
}

TEST(Photon, mean_colour_has_no_bias) {
  // One colour, many photons, as from one lamp: false alarms 1e-6 for all 3·20 t-tests together.
  Rng rng(3, 0, 0);
  const double level = statistics::sidak_level(1e-6, 60);
  for (int i = 0; i < 20; ++i) {
    // Channels of less than 0.01 are rounded up too seldom for a t-test.
    const Vec3 u(rng.next_float(), rng.next_float(), rng.next_float());
    const Color color = std::exp2(0.5f * i) * (0.01f + u * u);
    Moments moments[3];
    for (int j = 0; j < 20000; ++j) {
      const Vec3 position(rng.next_float(), rng.next_float(), 0.25f);
      const Color power = make_photon(position, Vec3(0, 0, 1), color, 1, false).power();
      for (int c = 0; c < 3; ++c) moments[c].add(power[c]);
    }
    for (int c = 0; c < 3; ++c) {
      EXPECT_GT(statistics::t_test(moments[c], color[c], 2.5e-7 * max_component(color)), level)
          << moments[c].mean() << " instead of " << color[c];
    }
  }
}

TEST(Photon, useless_powers_are_black_or_clamped) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (const Color color : {Color(0), Color(-1), Color(nan), Color(1e-30f), Color(-kInfinity)}) {
    EXPECT_TRUE(is_black(unpack_color(pack_color(color, 12345))));
  }
  EXPECT_EQ(unpack_color(pack_color(Color(kInfinity), ~0ull)), Color(0x1p64f));
  const Color mixed = unpack_color(pack_color(Color(nan, 1, -1), 0));
  EXPECT_EQ(mixed, Color(0, 1, 0));
}

}  // namespace
}  // namespace guidelight

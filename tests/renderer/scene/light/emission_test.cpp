// sample_emission and its densities, for every kind of light.

#include <gtest/gtest.h>

#include "tests/renderer/scene/light/light_cases.h"
#include "tests/renderer/scene/light/light_statistics.h"
#include "tests/renderer/scene/shape_cases.h"

namespace guidelight {
namespace {

using namespace light_test;

class Emission : public ::testing::TestWithParam<Case> {
 protected:
  Lamp lamp_ = GetParam().make();
  const double level_ = statistics::sidak_level(kFamilyLevel, all_lights().size());
};

TEST_P(Emission, SamplesCarryTheirDensities) {
  const Light& light = *lamp_.light;
  Rng rng(3, 0, 0);
  int emitted = 0;
  int other_texel = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec2 u_position = rng.next_vec2();
    const auto sample = light.sample_emission(u_position, rng.next_vec2());
    if (!sample) continue;
    ++emitted;
    const Vec3 w = sample->ray.direction;
    ASSERT_NEAR(glm::length(w), 1, 1e-5f);
    const EmissionPdf pdf = light.pdf_emission(sample->point, w);
    if (light.is_delta_position()) {
      ASSERT_EQ(sample->pdf_position, 1);
      ASSERT_EQ(pdf.position, 0);
    } else {
      ASSERT_NEAR(pdf.position / sample->pdf_position, 1, 1e-3f);
    }
    if (light.is_delta_direction()) {
      ASSERT_EQ(sample->pdf_direction, 1);
      ASSERT_EQ(pdf.direction, 0);
    } else if (sample->cos_light > 0.02f && pdf.direction > 0) {
      other_texel += std::abs(pdf.direction / sample->pdf_direction - 1) > 1e-2f;
    }
    if (lamp_.shape) {
      const Color expected = light.radiance(sample->point, w) * sample->cos_light /
                             (sample->pdf_position * sample->pdf_direction);
      ASSERT_NEAR(glm::length(expected - sample->weight), 0, 1e-3f * glm::length(expected));
      SurfacePoint again;  // the ray has left the lamp, except for one that looks inwards
      ASSERT_TRUE(std::string(GetParam().name) == "around_it" ||
                  !lamp_.intersect(sample->ray, again));
    }
  }
  EXPECT_GT(emitted, 15000);
  // Where a picture gives the density, it jumps between texels, and rounding may take a direction
  // back to the neighbour of the texel it was drawn in: 0.1 of 20000 samples are that close.
  const bool is_picture = std::string(GetParam().name) == "projector" ||
                          std::string(GetParam().name) == "environment" ||
                          std::string(GetParam().name) == "sky";
  EXPECT_LE(other_texel, is_picture ? 2 : 0);
}

TEST_P(Emission, DirectionsAreDistributedAsPdfSays) {
  const Light& light = *lamp_.light;
  if (light.is_delta_direction()) return;  // the density is discrete and was compared above
  SurfacePoint up;  // area lights emit alike everywhere, relative to the normal
  if (lamp_.shape) {
    SurfacePoint any;
    lamp_.shape->sample_area(Vec2(0.4f), any);
    up.position = any.position;
  }
  const auto draw = [&](Rng& rng) {
    const Vec2 u_position = rng.next_vec2();
    const auto sample = light.sample_emission(u_position, rng.next_vec2());
    if (!sample) return DrawnDirection{};
    const Frame frame = Frame::from_normal(sample->point.geometric_normal);
    const Vec3 w = sample->ray.direction;
    return DrawnDirection{lamp_.shape ? frame.to_local(w) : w, sample->pdf_direction};
  };
  const auto density = [&](Vec3 w) { return light.pdf_emission(up, w).direction; };
  if (light.is_delta_position()) {
    expect_solid_angles(
        draw, [&](Vec3 w) { return density(w) > 0 ? 1 : 0; }, all_lights().size());
    return;
  }
  expect_distribution([&](Rng& rng) { return draw(rng).w; }, density, 4, level_);
}

/// The power through a disc, from the disc (sample_direct) and from the light (sample_emission).
TEST_P(Emission, BringsAsMuchAsDirectSamplingFinds) {
  const auto receiver =
      make_shape(shape_test::describe(DiskShape{}, glm::rotate(Mat4(1), kPi, Vec3(1, 0.3f, 0))));
  Accelerator target(1);
  target.add_shape(*receiver, 0);
  target.build();

  Rng rng(5, 0, 0);
  statistics::Moments gathered;
  for (int i = 0; i < 200000; ++i) {
    SurfacePoint at;
    const float pdf_area = receiver->sample_area(rng.next_vec2(), at);
    const auto sample = lamp_.light->sample_direct(at.position, rng.next_vec2());
    const float cosine = sample ? glm::dot(at.geometric_normal, sample->wi) : 0;
    gathered.add(cosine > 0 ? luminance(sample->radiance) * cosine / (sample->pdf * pdf_area) : 0);
  }
  statistics::Moments brought;
  for (int i = 0; i < 400000; ++i) {
    const Vec2 u_position = rng.next_vec2();
    const auto sample = lamp_.light->sample_emission(u_position, rng.next_vec2());
    double power = 0;
    if (sample) {
      const Hit hit = target.intersect(sample->ray);
      SurfacePoint point;
      if (hit.valid()) {
        receiver->fill(sample->ray, hit, point);
        if (glm::dot(point.geometric_normal, sample->ray.direction) < 0)
          power = luminance(sample->weight);
      }
    }
    brought.add(power);
  }
  ASSERT_GT(gathered.mean(), 0);
  EXPECT_GT(statistics::welch_test(gathered, brought), level_)
      << gathered.mean() << " ± " << gathered.standard_error() << ", " << brought.mean() << " ± "
      << brought.standard_error();
}

TEST_P(Emission, PowerIsWhatIsEmitted) {
  statistics::Moments emitted;
  Rng rng(6, 0, 0);
  for (int i = 0; i < 100000; ++i) {
    const Vec2 u_position = rng.next_vec2();
    const auto sample = lamp_.light->sample_emission(u_position, rng.next_vec2());
    emitted.add(sample ? luminance(sample->weight) : 0);
  }
  // power() takes the mean of an image texel by texel, emission interpolates between texels: for
  // the coarse latitude-longitude image here, that differs by under 2 %.
  const bool is_image = GetParam().name == std::string("environment");
  const double power = lamp_.light->power();
  EXPECT_GT(statistics::t_test(emitted, power, (is_image ? 0.02 : 1e-4) * power), level_)
      << emitted.mean() << " for " << power;
}

INSTANTIATE_TEST_SUITE_P(All, Emission, ::testing::ValuesIn(all_lights()), kCaseName);

}  // namespace
}  // namespace guidelight

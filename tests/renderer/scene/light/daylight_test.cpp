#include "renderer/scene/light/daylight.h"

#include <gtest/gtest.h>

#include "renderer/scene/light/light.h"

namespace guidelight {
namespace {

Vec3 at_zenith_angle(float degrees) {
  const float theta = degrees * kPi / 180;
  return {std::sin(theta), std::cos(theta), 0};
}

/// Photometric luminance [cd/m²] of a radiance averaged over the visible spectrum.
float candelas(Color c) { return luminance(c) * 683 * 106.857f; }

TEST(Daylight, ZenithLuminanceIsThePapers) {
  // Yz = (4.0453 T - 4.9710) tan((4/9 - T/120)(π - 2θ)) - 0.2155 T + 2.4192 [kcd/m²], worked out by
  // hand for θ = 60° and T = 3: χ = 0.439241, tan χ = 0.470008, Yz = 5.140325.
  const Daylight daylight(at_zenith_angle(60), 3);
  EXPECT_NEAR(candelas(daylight.sky_radiance({0, 1, 0})), 5140, 10);
}

TEST(Daylight, ClearSkyIsBlueAndBrightestAroundTheSun) {
  const Daylight daylight(at_zenith_angle(50), 2.5f);
  const Color zenith = daylight.sky_radiance({0, 1, 0});
  EXPECT_GT(zenith.b, 1.5f * zenith.r);
  const Color near_sun = daylight.sky_radiance(at_zenith_angle(48));
  const Color opposite = daylight.sky_radiance(at_zenith_angle(-48));
  EXPECT_GT(luminance(near_sun), 3 * luminance(opposite));
  EXPECT_EQ(daylight.sky_radiance({0, -0.1f, 1}), Color(0));
}

TEST(Daylight, SunHasThePowerOfTheSun) {
  // A clear noon sun gives about 100 klx; the solar constant is 128 klx.
  const float solid_angle = kPi * sqr(Daylight::kSunAngularRadius);
  const float noon = candelas(Daylight({0, 1, 0}, 2).sun_radiance()) * solid_angle;
  EXPECT_GT(noon, 85e3f);
  EXPECT_LT(noon, 128e3f);
  const Color low = Daylight(at_zenith_angle(87), 3).sun_radiance();
  EXPECT_LT(candelas(low) * solid_angle, 0.2f * noon);
  EXPECT_GT(low.r, 2 * low.b);
  EXPECT_EQ(Daylight({0, -0.1f, 1}, 3).sun_radiance(), Color(0));
}

TEST(Daylight, SunAndSkyAreSwitchedAndScaled) {
  EmitterDescription description;
  SunSkyEmitter emitter;
  emitter.sun_direction = at_zenith_angle(40);
  const auto lights = [&] {
    description.model = emitter;
    return make_lights(description, {});
  };
  const auto both = lights();
  ASSERT_EQ(both.size(), 2u);
  const Light& sun = *both[0];
  const Light& sky = *both[1];
  EXPECT_GT(luminance(sun.radiance_from(emitter.sun_direction)), 1000);
  EXPECT_EQ(luminance(sun.radiance_from({0, 1, 0})), 0);
  const Color zenith = Daylight(emitter.sun_direction, emitter.turbidity).sky_radiance({0, 1, 0});
  EXPECT_NEAR(glm::length(sky.radiance_from({0, 1, 0}) - zenith), 0, 0.02f * glm::length(zenith));

  emitter.sun_scale = 2;
  emitter.sun_radius_scale = 10;  // the same power from a hundred times the solid angle
  emitter.sky = false;
  const auto large = lights();
  ASSERT_EQ(large.size(), 1u);
  EXPECT_NEAR(large[0]->power() / sun.power(), 2, 1e-2);
  emitter.sun = false;
  EXPECT_TRUE(lights().empty());
}

}  // namespace
}  // namespace guidelight

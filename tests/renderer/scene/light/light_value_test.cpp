// Values of lights that are known in closed form, and descriptions that are refused.

#include <gtest/gtest.h>

#include "renderer/error.h"
#include "renderer/sampling/random.h"
#include "tests/renderer/scene/light/light_cases.h"
#include "tests/renderer/scene/shape_cases.h"
#include "tests/statistics/hypothesis_tests.h"

namespace guidelight {
namespace {

using namespace light_test;
using namespace shape_test;

/// Irradiance at a point of a surface with normal n, by direct sampling.
statistics::Moments irradiance(const Light& light, Vec3 position, Vec3 n) {
  statistics::Moments result;
  Rng rng(7, 0, 0);
  for (int i = 0; i < 200000; ++i) {
    const auto sample = light.sample_direct(position, rng.next_vec2());
    const float cosine = sample ? glm::dot(n, sample->wi) : 0;
    result.add(cosine > 0 ? sample->radiance.r * cosine / sample->pdf : 0);
  }
  return result;
}

const double kValueLevel = statistics::sidak_level(1e-3, 8);

TEST(LightValue, SphereSeenFromOutside) {
  // A sphere of radiance L in the zenith: E = π L (r/d)².
  for (const float distance : {1.05f, 3.0f, 1000.0f}) {
    const Lamp lamp = area_lamp(describe(SphereShape{}, placed({0, 0, distance}, Vec3(1))));
    const double expected = kPi * 2 / sqr(double(distance));
    EXPECT_GT(statistics::t_test(irradiance(*lamp.light, Vec3(0), Vec3(0, 0, 1)), expected,
                                 1e-4 * expected),
              kValueLevel);
  }
}

TEST(LightValue, TinySphereFarFromTheOrigin) {
  const Vec3 center(300, 400, -500);
  const Lamp lamp = area_lamp(describe(SphereShape{}, placed(center, Vec3(1e-3f))));
  const Vec3 reference = center - Vec3(0, 0, 2);
  const double expected = kPi * 2 * 1e-6 / 4;
  const auto found = irradiance(*lamp.light, reference, {0, 0, 1});
  EXPECT_NEAR(found.mean() / expected, 1, 1e-3);
}

TEST(LightValue, DiskOnItsAxis) {
  // E = π L R²/(R² + h²).
  const Mat4 down = glm::translate(Mat4(1), Vec3(0, 0, 2)) *
                    glm::rotate(Mat4(1), kPi, Vec3(1, 0, 0)) * glm::scale(Mat4(1), Vec3(1.5f));
  const Lamp lamp = area_lamp(describe(DiskShape{}, down));
  const double expected = kPi * 2 * 2.25 / (2.25 + 4);
  EXPECT_GT(statistics::t_test(irradiance(*lamp.light, Vec3(0), Vec3(0, 0, 1)), expected, 1e-5),
            kValueLevel);
}

TEST(LightValue, PointLightFallsOffWithTheSquare) {
  const Lamp lamp = other_lamp(PointEmitter{{0, 0, 4}, Color(3)});
  const auto sample = lamp.light->sample_direct({0, 0, 1}, {});
  ASSERT_TRUE(sample);
  EXPECT_FLOAT_EQ(sample->radiance.r, 3.0f / 9);
  EXPECT_FLOAT_EQ(sample->distance, 3);
}

TEST(LightValue, ConstantSurroundingsGivePi) {
  const Lamp lamp = other_lamp(ConstantEmitter{Color(2)});
  EXPECT_GT(statistics::t_test(irradiance(*lamp.light, Vec3(0), Vec3(0.6f, 0, 0.8f)), 2 * kPi),
            kValueLevel);
}

TEST(LightValue, SpotFallsOffLinearlyInAngle) {
  SpotEmitter emitter;
  emitter.cutoff_angle = 0.6f;
  emitter.beam_width = 0.2f;
  const Lamp lamp = other_lamp(emitter);
  const auto intensity = [&](float angle) {
    const auto sample = lamp.light->sample_direct({std::sin(angle), 0, std::cos(angle)}, {});
    return sample ? sample->radiance.r : 0.0f;
  };
  EXPECT_NEAR(intensity(0.1f), 1, 1e-5f);
  EXPECT_NEAR(intensity(0.3f), 0.75f, 1e-4f);
  EXPECT_NEAR(intensity(0.5f), 0.25f, 1e-4f);
  EXPECT_EQ(intensity(0.7f), 0);
  EXPECT_EQ(intensity(3.0f), 0);
}

TEST(LightValue, ProjectorShowsItsImageOnAWhiteScreen) {
  auto image = std::make_shared<Image>(4, 2, 3);
  for (int c = 0; c < 3; ++c) image->pixel(0, 0)[c] = 5;  // top left
  const Lamp lamp = other_lamp(ProjectorEmitter{Mat4(1), image, kPi / 2, 1});
  // The screen at z = 1 is 2 wide and 1 high, +x is left: the centre of that texel is (0.75, 0.25).
  const Vec3 on_screen(0.75f, 0.25f, 1);
  const auto sample = lamp.light->sample_direct(on_screen, {});
  ASSERT_TRUE(sample);
  const float reflected = sample->radiance.r * -sample->wi.z * kInvPi;
  EXPECT_NEAR(reflected, 5, 1e-4f);
  EXPECT_FALSE(lamp.light->sample_direct({1.1f, 0, 1}, {}));
  EXPECT_FALSE(lamp.light->sample_direct({0, 0, -1}, {}));
}

TEST(LightValue, AreaLightsEmitOnTheOutsideOnly) {
  const Lamp lamp = area_lamp(describe(square()));
  EXPECT_TRUE(lamp.light->sample_direct({0, 0, 1}, Vec2(0.5f)));
  EXPECT_FALSE(lamp.light->sample_direct({0, 0, -1}, Vec2(0.5f)));
}

std::shared_ptr<Image> black_image() { return std::make_shared<Image>(8, 4, 3); }

TEST(EnvironmentLight, OrientationIsMitsubas) {
  // u = atan2(x, -z)/2π, v = acos(y)/π.
  const std::tuple<int, int, Vec3> texels[] = {{2, 1, {1, 0, 0}},
                                               {6, 1, {-1, 0, 0}},
                                               {4, 1, {0, 0, 1}},
                                               {0, 1, {0, 0, -1}},
                                               {3, 0, {0, 1, 0}}};
  for (const auto& [x, y, direction] : texels) {
    auto image = black_image();
    // The direction lies on the border of texels; light all around it.
    for (const int dx : {-1, 0}) {
      for (const int dy : {0, 1}) image->pixel((x + dx + 8) % 8, y + dy)[0] = 1;
    }
    const bool is_pole = direction.y > 0;
    for (int i = 0; is_pole && i < 8; ++i) image->pixel(i, 0)[0] = 1;
    const Lamp lamp = other_lamp(EnvironmentEmitter{image, Mat4(1), 1});
    EXPECT_NEAR(lamp.light->radiance_from(direction).r, 1, 1e-5f);
    EXPECT_EQ(lamp.light->radiance_from(-direction).r, 0);
  }
}

TEST(EnvironmentLight, BrokenTexelsDoNotSpread) {
  auto image = black_image();
  image->pixel(2, 1)[0] = kInfinity;
  image->pixel(5, 2)[1] = std::numeric_limits<float>::quiet_NaN();
  image->pixel(6, 2)[1] = -3;
  image->pixel(7, 2)[1] = 2;
  const Lamp lamp = other_lamp(EnvironmentEmitter{image, Mat4(1), 1});
  EXPECT_TRUE(std::isfinite(lamp.light->power()));
  Rng rng(8, 0, 0);
  for (int i = 0; i < 10000; ++i) {
    const auto sample = lamp.light->sample_direct({}, rng.next_vec2());
    ASSERT_TRUE(sample);
    ASSERT_TRUE(is_finite(sample->radiance) && min_component(sample->radiance) >= 0);
    ASSERT_TRUE(std::isfinite(sample->pdf) && sample->pdf > 0);
    ASSERT_LE(max_component(sample->radiance), 65504.0f);
  }
}

TEST(Light, BrokenDescriptionsAreErrors) {
  const auto make = [](decltype(EmitterDescription::model) model) {
    EmitterDescription description;
    description.model = std::move(model);
    return make_lights(description, context());
  };
  EXPECT_THROW(make(EnvironmentEmitter{}), Error);
  EXPECT_THROW(make(EnvironmentEmitter{black_image(), Mat4(0), 1}), Error);
  EXPECT_THROW(make(ProjectorEmitter{}), Error);
  EXPECT_THROW(make(DirectionalEmitter{Vec3(0), Color(1)}), Error);
  SpotEmitter flat;
  flat.to_world[2] = flat.to_world[1];
  EXPECT_THROW(make(flat), Error);
}

}  // namespace
}  // namespace guidelight

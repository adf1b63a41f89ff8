#include "renderer/scene/light/light.h"

#include <gtest/gtest.h>

#include <functional>

#include "renderer/error.h"
#include "renderer/sampling/random.h"
#include "renderer/sampling/warp.h"
#include "renderer/scene/accelerator.h"
#include "tests/renderer/scene/shape_cases.h"
#include "tests/statistics/hypothesis_tests.h"
#include "tests/statistics/sphere_histogram.h"

/// sample_direct, sample_emission and their densities, for every kind of light.
namespace guidelight {
namespace {

using namespace shape_test;

const Color kRadiance(2, 1, 0.5f);

/// A light, with the surface it lies on if it has one.
struct Lamp {
  std::unique_ptr<Shape> shape;
  std::unique_ptr<Accelerator> accelerator;
  std::unique_ptr<Light> light;

  /// The point of the light that a ray meets; false if it misses.
  bool intersect(const Ray& ray, SurfacePoint& point) const {
    const Hit hit = accelerator->intersect(ray);
    if (hit.valid()) shape->fill(ray, hit, point);
    return hit.valid();
  }
};

LightContext context() {
  LightContext result;
  result.scene_center = {0.5f, 0, 0};
  result.scene_radius = 4;
  return result;
}

Lamp area_lamp(const ShapeDescription& description) {
  Lamp lamp;
  lamp.shape = make_shape(description);
  lamp.accelerator = std::make_unique<Accelerator>(1);
  lamp.accelerator->add_shape(*lamp.shape, 0);
  lamp.accelerator->build();
  lamp.light = make_area_light({kRadiance, kNone}, *lamp.shape, context());
  return lamp;
}

Lamp other_lamp(decltype(EmitterDescription::model) model) {
  EmitterDescription description;
  description.name = "test";
  description.model = std::move(model);
  Lamp lamp;
  auto lights = make_lights(description, context());
  EXPECT_EQ(lights.size(), 1u);
  lamp.light = std::move(lights.at(0));
  return lamp;
}

std::shared_ptr<const Image> noise_image(int width, int height) {
  auto image = std::make_shared<Image>(width, height, 3);
  Rng rng(99, 0, 0);
  for (float& v : image->data()) v = rng.next_float() < 0.4f ? 0 : 3 * sqr(rng.next_float());
  return image;
}

/// Looks from (0,1,-2.5) at the origin, roughly.
Mat4 towards_receiver() {
  return glm::translate(Mat4(1), Vec3(0, 1, -2.5f)) * glm::rotate(Mat4(1), 0.3f, Vec3(1, 0.2f, 0));
}

SunSkyEmitter sun_sky(bool sun, bool sky) {
  SunSkyEmitter emitter;
  emitter.sun = sun;
  emitter.sky = sky;
  emitter.sun_direction = glm::normalize(Vec3(0.3f, 1, -0.8f));
  emitter.sun_radius_scale = 200;
  emitter.to_world = glm::rotate(Mat4(1), 0.4f, Vec3(0.2f, 1, 0));
  return emitter;
}

struct Case {
  const char* name;
  std::function<Lamp()> make;
};

const std::vector<Case> kAreaLights = {
    {"rectangle",
     [] {
       return area_lamp(describe(square(), placed({0, 1, -2.5f}, {1.5f, 0.7f, 1})));
     }},
    {"cube",
     [] {
       return area_lamp(describe(cube(), placed({0.6f, 0.4f, -2.5f}, {0.5f, 0.7f, 0.2f})));
     }},
    {"sphere",
     [] {
       return area_lamp(describe(SphereShape{}, placed({0, 1, -2.5f}, Vec3(0.8f))));
     }},
    {"ellipsoid",
     [] {
       return area_lamp(describe(SphereShape{}, placed({0, 1, -2.5f}, {1.5f, 0.6f, 0.3f})));
     }},
    {"disk",
     [] {
       return area_lamp(describe(DiskShape{}, placed({0, 1, -2.5f}, {1, 0.5f, 1})));
     }},
    {"cylinder",
     [] {
       return area_lamp(describe(CylinderShape{}, placed({0, 1, -2.5f}, {0.5f, 0.4f, 1})));
     }},
    {"around_it", [] { return area_lamp(describe(SphereShape{}, placed({}, Vec3(4)), true)); }},
};

EnvironmentEmitter environment() { return {noise_image(13, 9), placed({}, {-1, 1, 1}), 0.7f}; }

const std::vector<Case> kDistantLights = {
    {"constant", [] { return other_lamp(ConstantEmitter{kRadiance}); }},
    {"environment", [] { return other_lamp(environment()); }},
    {"sun", [] { return other_lamp(sun_sky(true, false)); }},
    {"sky", [] { return other_lamp(sun_sky(false, true)); }},
};

SpotEmitter spot() {
  SpotEmitter emitter;
  emitter.to_world = towards_receiver();
  emitter.cutoff_angle = 0.5f;
  emitter.beam_width = 0.2f;
  return emitter;
}

const std::vector<Case> kDeltaLights = {
    {"point",
     [] {
       return other_lamp(PointEmitter{{0, 1, -2.5f}, kRadiance});
     }},
    {"spot", [] { return other_lamp(spot()); }},
    {"projector",
     [] {
       return other_lamp(ProjectorEmitter{towards_receiver(), noise_image(7, 5), 0.8f, 2});
     }},
    {"directional",
     [] {
       return other_lamp(DirectionalEmitter{{1, -2, 3}, kRadiance});
     }},
};

std::vector<Case> all_lights() {
  std::vector<Case> all = kAreaLights;
  all.insert(all.end(), kDistantLights.begin(), kDistantLights.end());
  all.insert(all.end(), kDeltaLights.begin(), kDeltaLights.end());
  return all;
}

std::vector<Case> non_delta_lights() {
  std::vector<Case> all = kAreaLights;
  all.insert(all.end(), kDistantLights.begin(), kDistantLights.end());
  return all;
}

constexpr int kParts = 24;

/// Integral over every cell of a grid, from one random point in each of 24² parts of equal solid
/// angle: makes no systematic error where the function jumps at a light's outline.
template <typename Function>
std::vector<double> integrate(const statistics::SphereGrid& grid, Function&& function) {
  constexpr int kCosines = 20 * kParts, kAzimuths = 40 * kParts;
  std::vector<double> integrals(grid.size());
  Rng rng(98, 0, 0);
  for (int i = 0; i < kCosines; ++i) {
    for (int j = 0; j < kAzimuths; ++j) {
      const float z = -1 + (static_cast<float>(i) + rng.next_float()) * 2 / kCosines;
      const float phi = (static_cast<float>(j) + rng.next_float()) * 2 * kPi / kAzimuths;
      const Vec3 w(safe_sqrt(1 - z * z) * std::cos(phi), safe_sqrt(1 - z * z) * std::sin(phi), z);
      integrals[grid.cell(w)] += 4 * std::numbers::pi * function(w) / (kCosines * kAzimuths);
    }
  }
  return integrals;
}

/// False alarm rate of each of the tests over all its lights.
constexpr double kFamilyLevel = 1e-3;

const auto kCaseName = [](const auto& test) { return test.param.name; };

/// A direction and the density with which it was drawn; density 0 is a sample that was dropped.
struct DrawnDirection {
  Vec3 w{0};
  float pdf = 0;
};

/// 1/pdf, averaged over the samples in a cell of directions, is the solid angle of that part of the
/// cell that can be sampled; `can_sample(w)` says which. (Where densities are infinite, though
/// integrable, as at the outline of a curved light that is sampled by area, counts could not be
/// compared with integrals.)
template <typename Draw, typename CanSample>
void expect_solid_angles(Draw&& draw, CanSample&& can_sample, size_t tests) {
  const statistics::SphereGrid grid;
  const double cell_size = 4 * std::numbers::pi / static_cast<double>(grid.size());
  // Of the reference: three standard deviations where an outline crosses all parts of a row.
  const double tolerance = 3 * 0.5 * std::pow(kParts, -1.5) * cell_size;
  const std::vector<double> expected = integrate(grid, can_sample);

  constexpr int kSamples = 60000;
  std::vector<std::pair<double, double>> sums(grid.size());  // of 1/pdf and its square
  Rng rng(1, 0, 0);
  for (int i = 0; i < kSamples; ++i) {
    const DrawnDirection drawn = draw(rng);
    if (drawn.pdf == 0) continue;
    auto& [sum, squares] = sums[grid.cell(drawn.w)];
    sum += 1 / drawn.pdf;
    squares += sqr(1.0 / drawn.pdf);
  }
  const double level = statistics::sidak_level(kFamilyLevel, tests * grid.size());
  for (size_t i = 0; i < grid.size(); ++i) {
    const double mean = sums[i].first / kSamples;
    const double error = std::sqrt((sums[i].second / kSamples - sqr(mean)) / kSamples);
    const double excess = std::max(0.0, std::abs(mean - expected[i]) - tolerance);
    if (excess == 0) continue;
    ASSERT_GT(statistics::student_t_p_value(excess / error, kSamples - 1), level)
        << "cell " << i << ": " << mean << " for " << expected[i];
  }
}

// ---------------------------------------------------------------------------------------------------
// Direct sampling

class DirectSampling : public testing::TestWithParam<Case> {
 protected:
  Lamp lamp_ = GetParam().make();

  /// Density and radiance that a path which is scattered from `reference` towards w finds.
  std::pair<float, Color> found(Vec3 reference, Vec3 w) const {
    if (lamp_.light->is_infinite()) {
      return {lamp_.light->pdf_direct_from(w), lamp_.light->radiance_from(w)};
    }
    SurfacePoint point;
    if (!lamp_.intersect({reference, w, kInfinity}, point)) return {0, Color(0)};
    return {lamp_.light->pdf_direct(reference, point), lamp_.light->radiance(point, -w)};
  }
};

class DistantDirectSampling : public DirectSampling {};

const Vec3 kReferences[] = {Vec3(0), Vec3(0.8f, -1, 1.5f), Vec3(0.1f, 0.5f, -1.5f)};

TEST_P(DirectSampling, EveryPartOfTheLightIsFoundAsOftenAsPdfSays) {
  for (const Vec3 reference : kReferences) {
    if (lamp_.light->is_infinite() && reference != Vec3(0)) continue;  // nothing depends on it
    expect_solid_angles(
        [&](Rng& rng) {
          const auto sample = lamp_.light->sample_direct(reference, rng.next_vec2());
          const bool lit = sample && !is_black(sample->radiance);
          return lit ? DrawnDirection{sample->wi, sample->pdf} : DrawnDirection{};
        },
        [&](Vec3 w) {
          const auto [pdf, radiance] = found(reference, w);
          return pdf > 0 && !is_black(radiance) ? 1 : 0;
        },
        non_delta_lights().size() * std::size(kReferences));
  }
}

/// Where the density is bounded, counts can be compared.
TEST_P(DistantDirectSampling, DirectionsAreDistributedAsPdfSays) {
  const statistics::SphereGrid grid;
  constexpr int kSamples = 60000;
  std::vector<double> observed(grid.size());
  Rng rng(1, 0, 0);
  for (int i = 0; i < kSamples; ++i) {
    const auto sample = lamp_.light->sample_direct(Vec3(0), rng.next_vec2());
    ASSERT_TRUE(sample);
    ++observed[grid.cell(sample->wi)];
  }
  std::vector<double> expected =
      integrate(grid, [&](Vec3 w) { return lamp_.light->pdf_direct_from(w); });
  double total = 0;
  for (const double e : expected) total += e;
  EXPECT_NEAR(total, 1, 2e-3);
  for (double& e : expected) e *= kSamples / total;
  EXPECT_GT(statistics::chi_square_test(observed, expected).p_value,
            statistics::sidak_level(kFamilyLevel, kDistantLights.size()));
}

TEST_P(DirectSampling, SamplesSayWhatRaysFind) {
  Rng rng(2, 0, 0);
  int compared = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec3 reference = kReferences[i % std::size(kReferences)];
    const auto sample = lamp_.light->sample_direct(reference, rng.next_vec2());
    if (!sample) continue;
    ASSERT_NEAR(glm::length(sample->wi), 1, 1e-5f);
    const EmissionPdf emission = lamp_.light->pdf_emission(sample->point, -sample->wi);
    ASSERT_NEAR(emission.position / sample->pdf_position, 1, 1e-3f);
    if (!lamp_.light->is_infinite()) {
      ASSERT_NEAR(glm::length(reference + sample->distance * sample->wi - sample->position), 0,
                  1e-4f);
      if (sample->cos_light < 0.02f) continue;  // too oblique to compare numbers
      ASSERT_NEAR(sample->cos_light, -glm::dot(sample->wi, sample->point.geometric_normal), 1e-4f);
    }
    ASSERT_NEAR(emission.direction / sample->pdf_direction, 1, 1e-2f);
    const auto [pdf, radiance] = found(reference, sample->wi);
    if (pdf == 0 && ++compared)
      continue;  // by rounding, at an edge; counted against the test below
    ASSERT_NEAR(pdf / sample->pdf, 1, 2e-2f);
    ASSERT_NEAR(glm::length(radiance - sample->radiance), 0,
                0.02f * (1e-3f + glm::length(radiance)));
    compared += 1000;
  }
  EXPECT_GT(compared / 1000, 200 * (compared % 1000));
  EXPECT_GT(compared / 1000, 5000);
}

INSTANTIATE_TEST_SUITE_P(All, DirectSampling, testing::ValuesIn(non_delta_lights()), kCaseName);
INSTANTIATE_TEST_SUITE_P(All, DistantDirectSampling, testing::ValuesIn(kDistantLights), kCaseName);

// ---------------------------------------------------------------------------------------------------
// Emission

class Emission : public testing::TestWithParam<Case> {
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
  up.position = lamp_.shape ? lamp_.shape->sample_area(Vec2(0.4f)).point.position : Vec3(0);
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
  const statistics::SphereGrid grid;
  constexpr int kSamples = 60000;
  std::vector<double> observed(grid.size());
  Rng rng(4, 0, 0);
  for (int i = 0; i < kSamples; ++i) ++observed[grid.cell(draw(rng).w)];
  std::vector<double> expected = integrate(grid, density);
  double total = 0;
  for (const double e : expected) total += e;
  EXPECT_NEAR(total, 1, 2e-3);
  for (double& e : expected) e *= kSamples / total;
  EXPECT_GT(statistics::chi_square_test(observed, expected).p_value, level_);
}

/// The power through a disc, from the disc (sample_direct) and from the light (sample_emission).
TEST_P(Emission, BringsAsMuchAsDirectSamplingFinds) {
  const auto receiver =
      make_shape(describe(DiskShape{}, glm::rotate(Mat4(1), kPi, Vec3(1, 0.3f, 0))));
  Accelerator target(1);
  target.add_shape(*receiver, 0);
  target.build();

  Rng rng(5, 0, 0);
  statistics::Moments gathered;
  for (int i = 0; i < 200000; ++i) {
    const ShapeSample at = receiver->sample_area(rng.next_vec2());
    const auto sample = lamp_.light->sample_direct(at.point.position, rng.next_vec2());
    const float cosine = sample ? glm::dot(at.point.geometric_normal, sample->wi) : 0;
    gathered.add(cosine > 0 ? luminance(sample->radiance) * cosine / (sample->pdf * at.pdf_area)
                            : 0);
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

INSTANTIATE_TEST_SUITE_P(All, Emission, testing::ValuesIn(all_lights()), kCaseName);

// ---------------------------------------------------------------------------------------------------
// Known values

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

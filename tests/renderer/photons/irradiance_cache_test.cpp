#include "renderer/photons/irradiance_cache.h"

#include <gtest/gtest.h>

#include "renderer/photons/hemisphere.h"
#include "renderer/sampling/random.h"

namespace guidelight {
namespace {

/// Inside of a unit sphere around the origin that glows unevenly: what is seen from a point within
/// is known for every direction.
Hemisphere::Sample look(Vec3 origin, Vec3 w) {
  const float b = glm::dot(origin, w);
  const float distance = -b + std::sqrt(b * b + 1 - length_squared(origin));
  const Vec3 p = origin + distance * w;
  return {Color(1 + 0.8f * p.x, 1 + 0.6f * p.y * p.z, 0.5f + p.z * p.z), distance};
}

Hemisphere look_around(Vec3 position, Vec3 normal, int count) {
  Hemisphere hemisphere(position, normal, count);
  for (size_t i = 0; i < hemisphere.size(); ++i) {
    hemisphere[i] = look(position, hemisphere.direction(i, Vec2(0.5f)));
  }
  return hemisphere;
}

Color irradiance(Vec3 position, Vec3 normal) {
  return look_around(position, normal, 200000).record().irradiance;
}

const Vec3 kPosition(0.2f, -0.1f, 0.15f);
const Vec3 kNormal = glm::normalize(Vec3(0.3f, 0.5f, 0.8f));

TEST(Hemisphere, irradiance_of_uniform_light_is_pi_times_radiance) {
  Hemisphere hemisphere(kPosition, kNormal, 100);
  for (size_t i = 0; i < hemisphere.size(); ++i) hemisphere[i] = {Color(2), 3};
  const IrradianceRecord record = hemisphere.record();
  EXPECT_NEAR(record.irradiance.g, 2 * kPi, 1e-4);
  EXPECT_NEAR(record.distance, 3, 1e-5);
  EXPECT_NEAR(glm::length(record.translational[1]), 0, 1e-4);
  EXPECT_NEAR(glm::length(record.rotational[1]), 0, 1e-3);
}

TEST(Hemisphere, gradients_are_derivatives) {
  // Against differences of the irradiance itself. The formula moves the strata's boundaries only,
  // which leaves an error of the order of a stratum.
  const IrradianceRecord record = look_around(kPosition, kNormal, 20000).record();
  const Frame frame = Frame::from_normal(kNormal);
  constexpr float kStep = 0.01f;
  for (const Vec3 axis : {frame.s, frame.t, glm::normalize(frame.s - 2.0f * frame.t)}) {
    const Color forward = irradiance(kPosition + kStep * axis, kNormal);
    const Color backward = irradiance(kPosition - kStep * axis, kNormal);
    const Vec3 turned_forward = glm::normalize(kNormal + kStep * axis);
    const Vec3 turned_backward = glm::normalize(kNormal - kStep * axis);
    const Color turned =
        irradiance(kPosition, turned_forward) - irradiance(kPosition, turned_backward);
    const Vec3 turn = glm::cross(turned_backward, turned_forward);
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(glm::dot(axis, record.translational[c]), (forward[c] - backward[c]) / (2 * kStep),
                  0.05)
          << "step, channel " << c;
      EXPECT_NEAR(glm::dot(turn, record.rotational[c]) / (2 * kStep), turned[c] / (2 * kStep), 0.03)
          << "turn, channel " << c;
    }
  }
}

TEST(Hemisphere, too_few_rays_and_empty_surroundings_are_no_trouble) {
  for (const int count : {-1, 0, 1, 2, 7}) {
    const IrradianceRecord record = Hemisphere(kPosition, kNormal, count).record();
    EXPECT_TRUE(is_black(record.irradiance));
    EXPECT_EQ(record.distance, kInfinity);
    for (int c = 0; c < 3; ++c) EXPECT_TRUE(is_finite(record.translational[c]));
  }
}

Bounds unit_box() {
  Bounds box;
  box.extend(Vec3(-1));
  box.extend(Vec3(1));
  return box;
}

TEST(IrradianceCache, interpolates_where_records_are_valid) {
  const float accuracy = 0.2f;
  IrradianceCache cache(unit_box(), {.accuracy = accuracy});
  EXPECT_FALSE(cache.interpolate(kPosition, kNormal, 0));
  cache.insert(look_around(kPosition, kNormal, 2000).record());
  const float reach = accuracy * cache.records()[0].distance;
  const Vec3 s = Frame::from_normal(kNormal).s;
  EXPECT_TRUE(cache.interpolate(kPosition, kNormal, 0));
  EXPECT_TRUE(cache.interpolate(kPosition + 0.99f * reach * s, kNormal, 0));
  EXPECT_FALSE(cache.interpolate(kPosition + 1.01f * reach * s, kNormal, 0));
  EXPECT_FALSE(cache.interpolate(kPosition, -kNormal, 0));
  EXPECT_FALSE(cache.interpolate(kPosition, glm::normalize(kNormal + s), 0));
  EXPECT_FALSE(cache.interpolate(kPosition, kNormal, 1)) << "another key";
  EXPECT_FALSE(cache.interpolate(kPosition - 0.5f * reach * kNormal, kNormal, 0))
      << "the record lies in front";
}

TEST(IrradianceCache, gradients_pay) {
  // One record, used all over where it is valid: with gradients the error is several times smaller.
  IrradianceCache with(unit_box(), {.accuracy = 0.3f});
  IrradianceCache without(unit_box(), {.accuracy = 0.3f});
  IrradianceRecord record = look_around(kPosition, kNormal, 2000).record();
  with.insert(record);
  const float reach = 0.3f * with.records()[0].distance;
  record.rotational = record.translational = {};
  record.distance = with.records()[0].distance;
  without.insert(record);
  Rng rng(3, 0, 0);
  const Frame frame = Frame::from_normal(kNormal);
  double error_with = 0;
  double error_without = 0;
  for (int i = 0; i < 50; ++i) {
    const Vec2 u = 2.0f * rng.next_vec2() - 1.0f;
    const Vec3 p = kPosition + 0.6f * reach * (u.x * frame.s + u.y * frame.t);
    const Vec2 v = 0.05f * (2.0f * rng.next_vec2() - 1.0f);
    const Vec3 n = glm::normalize(kNormal + v.x * frame.s + v.y * frame.t);
    const auto a = with.interpolate(p, n, 0);
    const auto b = without.interpolate(p, n, 0);
    if (!a || !b) continue;
    const Color truth = look_around(p, n, 20000).record().irradiance;
    error_with += max_component(glm::abs(*a - truth));
    error_without += max_component(glm::abs(*b - truth));
  }
  EXPECT_GT(error_without, 0);
  EXPECT_LT(error_with, 0.35 * error_without);
}

/// Records over a small bright opening: few rays meet it, and those that do bring a steep gradient.
/// If bright records reached less far for it, the mean of the interpolation would be too dark.
TEST(IrradianceCache, steep_gradients_of_noise_take_no_light_away) {
  constexpr int kRuns = 400;
  Rng rng(7, 0, 0);
  double sum = 0;
  for (int run = 0; run < kRuns; ++run) {
    IrradianceCache cache(unit_box(), {.accuracy = 0.2f});
    for (int i = 0; i < 200; ++i) {
      IrradianceRecord record;
      const Vec2 u = 2.0f * rng.next_vec2() - 1.0f;
      record.position = Vec3(u.x, u.y, 0);
      record.distance = 1;
      if (rng.next_float() < 0.1f) {
        record.irradiance = Color(10);
        const float angle = 2 * kPi * rng.next_float();
        record.translational.fill(80.0f * Vec3(std::cos(angle), std::sin(angle), 0));
      }
      cache.insert(record);
    }
    sum += cache.interpolate(Vec3(0), {0, 0, 1}, 0).value_or(Color(1)).g;
  }
  // About six records reach the point: a standard deviation of 0.07. Four of these, 6e-5.
  EXPECT_NEAR(sum / kRuns, 1, 0.28);
}

TEST(IrradianceCache, finds_every_valid_record_through_the_octree) {
  // Equal weights everywhere would hide a lost record, so irradiance is the number of the record.
  IrradianceCache cache(unit_box(), {.accuracy = 0.2f});
  Rng rng(5, 0, 0);
  for (int i = 0; i < 300; ++i) {
    IrradianceRecord record;
    record.position = Vec3(rng.next_float(), rng.next_float(), rng.next_float()) * 2.2f - 1.1f;
    record.distance = std::exp2(-6 * rng.next_float());
    record.irradiance = Color(static_cast<float>(i + 1));
    cache.insert(record);
  }
  for (int i = 0; i < 2000; ++i) {
    const Vec3 p = Vec3(rng.next_float(), rng.next_float(), rng.next_float()) * 2.0f - 1.0f;
    double sum = 0;
    double weights = 0;
    for (const IrradianceRecord& record : cache.records()) {
      const Vec3 offset = p - record.position;
      const double error = glm::length(offset) / record.distance;
      if (error >= 0.2 || 2 * offset.z < -0.02 * record.distance) continue;
      const double weight = 1 / std::max(error, 1e-4) - 5;
      sum += weight * record.irradiance.r;
      weights += weight;
    }
    const auto found = cache.interpolate(p, {0, 0, 1}, 0);
    ASSERT_EQ(found.has_value(), weights > 0);
    if (!found) continue;
    ASSERT_NEAR(found->r, sum / weights, 1e-3 * sum / weights);
  }
}

}  // namespace
}  // namespace guidelight

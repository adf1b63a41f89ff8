// Guides propose what their density says, on every kind of light. False alarms of the whole file:
// 1e-3 for each test, over all its lights.

#include "renderer/transport/guide_mixture.h"

#include <gtest/gtest.h>

#include "renderer/sampling/random.h"
#include "renderer/sampling/warp.h"
#include "renderer/transport/guide_check.h"
#include "tests/renderer/transport/guide_scenes.h"
#include "tests/statistics/hypothesis_tests.h"

namespace guidelight {
namespace {

using guide_test::LitScene;
using statistics::Moments;

/// Cells of first segments: halves of the light in x and z, and where on the floor they lead.
constexpr int kMixtureCells = 4 * 16;
int cell_of(Vec3 origin, Vec3 direction, Vec3 center) {
  const float t = (-1 - origin.y) / direction.y;
  const Vec3 floor = origin + t * direction;
  const auto along = [](float x) { return std::clamp(static_cast<int>(2 + 2 * x), 0, 3); };
  return 32 * (origin.x > center.x) + 16 * (origin.z > center.z) + 4 * along(floor.x) +
         along(floor.z);
}

class GuideMixtureTest : public ::testing::TestWithParam<LitScene> {
 protected:
  std::shared_ptr<const Scene> scene_ = GetParam().build();
  std::vector<GuidePath> guides_ = guide_test::guides_for(*scene_, GetParam());
  std::shared_ptr<const GuideMixture> mixture_ = GuideMixture::build(scene_, guides_);
};

TEST_P(GuideMixtureTest, TracedGuidesAreGood) {
  for (size_t i = 0; i < guides_.size(); ++i) {
    for (const GuideFault& fault : check_guide(*scene_, guides_[i])) {
      ADD_FAILURE() << "guide " << i << ", vertex " << fault.vertex << ": " << fault.message;
    }
  }
  ASSERT_EQ(mixture_->size(), guides_.size());
  EXPECT_FLOAT_EQ(mixture_->weight(0), 0.4f);
  EXPECT_EQ(mixture_->length(0), 1);
  EXPECT_EQ(mixture_->length(1), 2);
}

/// Counts and weights by cell; a cell that gets nothing gets zeros.
class Cells {
 public:
  void add(int cell, double value) { sums_[cell].push_back(value), ++count_; }
  void add_nothing() { ++count_; }
  size_t hits(int cell) const { return sums_[cell].size(); }
  Moments moments(int cell) const {
    Moments result;
    for (const double value : sums_[cell]) result.add(value);
    for (size_t i = hits(cell); i < count_; ++i) result.add(0);
    return result;
  }

 private:
  std::vector<double> sums_[kMixtureCells];
  size_t count_ = 0;
};

/// The first segments that a guide proposes against those of ordinary emission, weighted by the
/// quotient of the densities: agrees cell by cell only if the density is the true one, its integral
/// included.
TEST_P(GuideMixtureTest, FirstSegmentsAreDistributedAsTheDensitySays) {
  constexpr int kGuided = 60000;
  constexpr int kOrdinary = 400000;
  const Light& light = *scene_->lights()[0];
  if (light.is_infinite()) {
    // Ordinary emission would seldom come near small ones.
    for (GuidePath& guide : guides_) guide.disc_radius = 0.6f, guide.vertices[0].cone = 0.6f;
    mixture_ = GuideMixture::build(scene_, guides_);
  }
  const Vec3 center = GetParam().start;
  const double level = statistics::sidak_level(
      statistics::kFalseAlarms, guide_test::lit_scenes().size() * guides_.size() * kMixtureCells);
  for (uint32_t j = 0; j < mixture_->size(); ++j) {
    Cells guided;
    Cells ordinary;
    Rng rng(5, 0, j);
    int without_density = 0;
    for (int i = 0; i < kGuided; ++i) {
      const Vec2 u = rng.next_vec2();
      const auto start = mixture_->start(j, u, rng.next_vec2());
      if (!start) {
        guided.add_nothing();
        continue;
      }
      const auto& [ray, point, weight, pdf_position, pdf_direction, cosine] = start->emission;
      ASSERT_EQ(start->light, &light);
      without_density += !(mixture_->pdf_start(j, light, point, ray.origin, ray.direction) > 0);
      guided.add(cell_of(ray.origin, ray.direction, center), 1);
    }
    EXPECT_LE(without_density, kGuided / 10000) << "rounding at the rims, but no more";
    for (int i = 0; i < kOrdinary; ++i) {
      const Vec2 u = rng.next_vec2();
      const auto sample = light.sample_emission(u, rng.next_vec2());
      const double pdf = sample && !is_black(sample->weight)
                             ? mixture_->pdf_start(j, light, sample->point, sample->ray.origin,
                                                   sample->ray.direction)
                             : 0.0;
      if (pdf == 0) {
        ordinary.add_nothing();
        continue;
      }
      ordinary.add(cell_of(sample->ray.origin, sample->ray.direction, center),
                   pdf / (double{sample->pdf_position} * sample->pdf_direction));
    }
    double compared = 0;
    double all = 0;
    for (int c = 0; c < kMixtureCells; ++c) {
      const Moments found = guided.moments(c);
      const Moments expected = ordinary.moments(c);
      all += found.mean();
      // Fewer have no normal distribution.
      if (guided.hits(c) < 50 || ordinary.hits(c) < 50) continue;
      compared += found.mean();
      EXPECT_GT(statistics::welch_test(found, expected), level)
          << "guide " << j << " cell " << c << ": " << found.mean() << " of the candidates, "
          << expected.mean() << " +- " << expected.standard_error() << " by the density";
    }
    EXPECT_GT(compared, 0.8 * all) << "guide " << j;
    EXPECT_GT(all, 0.05) << "guide " << j;
  }
}

/// Emission has the same value whoever draws it.
TEST_P(GuideMixtureTest, EmissionIsThatOfTheLight) {
  Rng rng(6, 0, 0);
  const Light& light = *scene_->lights()[0];
  for (int i = 0; i < 2000; ++i) {
    const Vec2 u = rng.next_vec2();
    const auto start = mixture_->start(i % 4, u, rng.next_vec2());
    if (!start) continue;
    const EmissionSample& sample = start->emission;
    const Vec3 w = sample.ray.direction;
    const EmissionPdf pdf = light.pdf_emission(sample.point, w);
    EXPECT_FLOAT_EQ(sample.pdf_position, light.is_delta_position() ? 1 : pdf.position);
    EXPECT_FLOAT_EQ(sample.pdf_direction, light.is_delta_direction() ? 1 : pdf.direction);
    const Color emitted = emitted_light(light, sample.point, w);
    const Color weighted = sample.weight * sample.pdf_position * sample.pdf_direction;
    EXPECT_NEAR(glm::length(weighted - emitted * sample.cos_light), 0,
                1e-4f * glm::length(emitted));
  }
}

TEST_P(GuideMixtureTest, DirectionsFillTheirCones) {
  const int vertex = 1;
  const uint32_t guide = 1;  // scatters at the wall
  Rng rng(7, 0, 0);
  Moments inside;
  const float pdf =
      mixture_->pdf_direction(guide, vertex, mixture_->sample_direction(guide, vertex, Vec2(0.5f)));
  EXPECT_NEAR(pdf * 2 * kPi * (1 - std::cos(0.4f)), 1, 1e-4);
  for (int i = 0; i < 100000; ++i) {
    const Vec3 w = mixture_->sample_direction(guide, vertex, rng.next_vec2());
    ASSERT_NEAR(glm::length(w), 1, 1e-5);
    const Vec3 anywhere = square_to_sphere(rng.next_vec2());
    inside.add(mixture_->pdf_direction(guide, vertex, anywhere) / kUniformSpherePdf);
  }
  EXPECT_GT(statistics::t_test(inside, 1), statistics::kFalseAlarms);
}

/// Of whole prefixes, where all guides but one have another length or other events.
TEST_P(GuideMixtureTest, PrefixesMatchLengthAndEvents) {
  const Light& light = *scene_->lights()[0];
  const auto pdf_prefix = [&](const EmissionSample& sample, std::span<const GuidedStep> steps) {
    double sum = 0;
    for (uint32_t j = 0; j < mixture_->size(); ++j) {
      if (mixture_->length(j) != static_cast<int>(steps.size())) continue;
      double pdf =
          mixture_->pdf_start(j, light, sample.point, sample.ray.origin, steps[0].direction);
      for (size_t i = 1; i < steps.size(); ++i) {
        pdf *= mixture_->pdf_step(j, static_cast<int>(i), steps[i]);
      }
      sum += mixture_->weight(j) * pdf;
    }
    return sum;
  };
  Rng rng(8, 0, 0);
  for (int i = 0; i < 200; ++i) {
    const Vec2 u = rng.next_vec2();
    const auto start = mixture_->start(2, u, rng.next_vec2());
    if (!start) continue;
    const EmissionSample& sample = start->emission;
    const Vec3 w = sample.ray.direction;
    const std::vector<GuidedStep> through = {{w}, {w, PathEvent::Refract}, {w, PathEvent::Refract}};
    const double pdf = pdf_prefix(sample, through);
    const double expected =
        mixture_->weight(2) * mixture_->pdf_start(2, light, sample.point, sample.ray.origin, w);
    EXPECT_DOUBLE_EQ(pdf, expected);
    const std::vector<GuidedStep> reflected = {
        {w}, {w, PathEvent::Reflect}, {w, PathEvent::Refract}};
    EXPECT_EQ(pdf_prefix(sample, reflected), 0);
  }
}

INSTANTIATE_TEST_SUITE_P(Lights, GuideMixtureTest, ::testing::ValuesIn(guide_test::lit_scenes()),
                         guide_test::kSceneName);

TEST(GuideMixtureBuild, LeavesOutWhatCannotBeUsed) {
  const LitScene& lit = guide_test::lit_scenes()[0];
  const auto scene = lit.build();
  std::vector<GuidePath> guides = guide_test::guides_for(*scene, lit);
  guides[0].enabled = false;
  guides[1].weight = 0;
  guides[3].vertices[0].position.y += 1;  // off the light
  const auto mixture = GuideMixture::build(scene, guides);
  ASSERT_EQ(mixture->size(), 1u);
  EXPECT_EQ(mixture->index_in_list(0), 2u);
  EXPECT_EQ(mixture->weight(0), 1);
  EXPECT_EQ(GuideMixture::build(scene, {}), nullptr);
  EXPECT_EQ(GuideMixture::build(scene, std::span(guides).first(2)), nullptr);
}

}  // namespace
}  // namespace guidelight

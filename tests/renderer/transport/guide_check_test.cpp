// Guides are traced and judged: each fault is found where it is, in words.

#include "renderer/transport/guide_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderer/transport/guide_trace.h"
#include "tests/renderer/transport/guide_scenes.h"

namespace guidelight {
namespace {

using ::testing::HasSubstr;

class GuideCheck : public ::testing::Test {
 protected:
  GuideCheck() : guides_(guide_test::guides_for(*scene_, lit_)) {}

  /// The first fault; fails if there is none.
  GuideFault fault(const GuidePath& guide) const {
    const auto faults = check_guide(*scene_, guide);
    EXPECT_FALSE(faults.empty());
    return faults.empty() ? GuideFault{} : faults.front();
  }
  GuidePath over_the_wall() const { return guides_[1]; }
  GuidePath through_the_ball() const { return guides_[2]; }

  const guide_test::LitScene& lit_ = guide_test::lit_scenes()[0];
  std::shared_ptr<const Scene> scene_ = lit_.build();
  std::vector<GuidePath> guides_;
};

TEST_F(GuideCheck, TracedGuidesAreFollowedThroughGlass) {
  const GuidePath guide = through_the_ball();
  ASSERT_EQ(guide.vertices.size(), 4u);
  EXPECT_EQ(guide.vertices[1].event, PathEvent::Refract);
  EXPECT_EQ(guide.vertices[2].event, PathEvent::Refract);
  EXPECT_NEAR(guide.vertices[3].position.y, -1, 1e-4);
  EXPECT_TRUE(check_guide(*scene_, guide).empty());
}

TEST_F(GuideCheck, AGuideMustStartOnALight) {
  GuidePath guide = over_the_wall();
  guide.vertices[0].position.y += 0.1f;
  EXPECT_EQ(fault(guide).vertex, 0);
  EXPECT_THAT(fault(guide).message, HasSubstr("no light"));
}

TEST_F(GuideCheck, ALightShinesFromItsFrontOnly) {
  GuidePath guide = over_the_wall();
  guide.vertices[1].position.y = 3;
  EXPECT_THAT(fault(guide).message, HasSubstr("no light"));
}

TEST_F(GuideCheck, ASegmentMustNotBeBlocked) {
  GuidePath guide = over_the_wall();
  // Straight down through the middle of the ball.
  guide.vertices[0].position = {0.25f, 0.9f, -0.25f};
  guide.vertices[1].position = {0.32f, -1, -0.32f};
  const GuideFault found = fault(guide);
  EXPECT_EQ(found.vertex, 1);
  EXPECT_THAT(found.message, HasSubstr("'sphere' blocks"));
}

TEST_F(GuideCheck, VerticesLieOnSurfaces) {
  GuidePath guide = over_the_wall();
  guide.vertices[1].position.z = -0.9f;
  EXPECT_EQ(fault(guide).vertex, 1);
  EXPECT_THAT(fault(guide).message, HasSubstr("before the surface"));
  guide.vertices[1].position = {9, -0.5f, 9};
  EXPECT_THAT(fault(guide).message, HasSubstr("no surface on the way"));
}

TEST_F(GuideCheck, AGuideEndsWhereLightIsScattered) {
  GuidePath guide = through_the_ball();
  guide.vertices.resize(2);
  EXPECT_EQ(fault(guide).vertex, 1);
  EXPECT_THAT(fault(guide).message, HasSubstr("ends on 'sphere'"));
}

TEST_F(GuideCheck, EventsAreThoseOfTheSurface) {
  GuidePath guide = through_the_ball();
  guide.vertices[1].event = PathEvent::Scatter;
  EXPECT_EQ(fault(guide).vertex, 1);
  EXPECT_THAT(fault(guide).message, HasSubstr("'reflect' or 'refract'"));

  guide = over_the_wall();
  guide.vertices[1].event = PathEvent::Reflect;
  EXPECT_EQ(fault(guide).vertex, 1);
  EXPECT_THAT(fault(guide).message, HasSubstr("does not reflect"));

  guide = through_the_ball();
  guide.vertices[2].event = PathEvent::Reflect;  // within the glass: leads elsewhere
  EXPECT_EQ(fault(guide).vertex, 3);
  EXPECT_THAT(fault(guide).message, HasSubstr("trace this part again"));

  guide = over_the_wall();
  guide.vertices[0].event = PathEvent::Reflect;
  EXPECT_THAT(fault(guide).message, HasSubstr("'scatter'"));
}

TEST_F(GuideCheck, NumbersMustMakeSense) {
  const auto message = [&](auto change) {
    GuidePath guide = over_the_wall();
    change(guide);
    return fault(guide).message;
  };
  EXPECT_THAT(message([](GuidePath& g) { g.vertices[1].position.x = NAN; }), HasSubstr("finite"));
  EXPECT_THAT(message([](GuidePath& g) { g.vertices[1].cone = 0; }), HasSubstr("cone"));
  EXPECT_THAT(message([](GuidePath& g) { g.vertices[0].cone = 2; }), HasSubstr("cone"));
  EXPECT_THAT(message([](GuidePath& g) { g.weight = -1; }), HasSubstr("weight"));
  EXPECT_THAT(message([](GuidePath& g) { g.disc_radius = NAN; }), HasSubstr("disc radius"));
  EXPECT_THAT(message([](GuidePath& g) { g.vertices.resize(1); }), HasSubstr("two vertices"));
  EXPECT_THAT(message([](GuidePath& g) { g.vertices.resize(1000); }), HasSubstr("at most"));
  EXPECT_THAT(message([](GuidePath& g) { g.vertices[1] = g.vertices[0]; }), HasSubstr("move one"));
}

TEST_F(GuideCheck, PathsAreTracedFromALightInADirection) {
  const Vec3 start(0, 0.9f, 0);
  const auto guide = trace_guide(*scene_, start, glm::normalize(Vec3(-0.4f, -1, 0.5f)), 1);
  ASSERT_TRUE(guide);
  ASSERT_EQ(guide->vertices.size(), 2u);
  EXPECT_TRUE(check_guide(*scene_, *guide).empty());
  // The wall sends it on like a mirror, to the floor.
  const auto longer = trace_guide(*scene_, start, glm::normalize(Vec3(-0.3f, -0.7f, -1)), 2);
  ASSERT_TRUE(longer);
  ASSERT_EQ(longer->vertices.size(), 3u);
  EXPECT_NEAR(longer->vertices[1].position.z, -1, 1e-5);
  EXPECT_NEAR(longer->vertices[2].position.y, -1, 1e-5);
  EXPECT_TRUE(check_guide(*scene_, *longer).empty());
  EXPECT_FALSE(trace_guide(*scene_, start, {0, 1, 0}, 1)) << "nothing above the lamp";
}

TEST_F(GuideCheck, NoGuideStartsFromNumbersThatAreNone) {
  const Vec3 down(0, -1, 0);
  const Vec3 start(0, 0.9f, 0);
  for (const float bad : {NAN, kInfinity, 1e30f}) {
    EXPECT_FALSE(trace_guide(*scene_, {bad, 0.9f, 0}, down, 1)) << bad;
    EXPECT_FALSE(trace_guide_through(*scene_, {bad, 0.9f, 0}, std::vector{Vec3(0)})) << bad;
  }
  EXPECT_FALSE(trace_guide(*scene_, start, {NAN, -1, 0}, 1));
  EXPECT_FALSE(trace_guide_through(*scene_, start, std::vector{start})) << "no way to go";
}

TEST_F(GuideCheck, GlassReflectsWhereThatIsChosen) {
  const Vec3 start(0, 0.9f, 0);
  const Vec3 towards_ball = glm::normalize(guide_test::kBall + Vec3(0, 0, -0.2f) - start);
  const auto guide = trace_guide(*scene_, start, towards_ball, 1, SpecularChoice::Reflect);
  ASSERT_TRUE(guide);
  ASSERT_EQ(guide->vertices.size(), 3u);
  EXPECT_EQ(guide->vertices[1].event, PathEvent::Reflect);
  EXPECT_TRUE(check_guide(*scene_, *guide).empty());
}

TEST_F(GuideCheck, ChainsAreSolvedForAPlaceBehindThem) {
  SurfacePoint from;
  from.position = {0, 0.89f, 0};  // just below the lamp
  const Vec3 guess = glm::normalize(guide_test::kBall + Vec3(0, 0, -0.2f) - from.position);
  const auto choice = SpecularChoice::Reflect;
  const auto first = trace_guide_segment(*scene_, {from.position, guess, kInfinity}, choice);
  ASSERT_TRUE(first);
  const Vec3 target = first->end.position + Vec3(0.1f, -0.15f, 0);  // on the wall, too
  const auto solved = solve_guide_segment(*scene_, from, guess, target, choice);
  ASSERT_TRUE(solved);
  EXPECT_EQ(solved->vertices.size(), first->vertices.size());
  EXPECT_LT(glm::distance(solved->end.position, target), guide_tolerance(*scene_));
  // The ball reflects nothing to a place in its own shadow.
  EXPECT_FALSE(solve_guide_segment(*scene_, from, guess, {0.35f, -1, -0.4f}, choice));
}

}  // namespace
}  // namespace guidelight

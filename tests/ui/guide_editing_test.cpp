#include "ui/guides/guide_editing.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "renderer/transport/guide_check.h"
#include "ui/guides/guide_draft.h"
#include "ui/undo_stack.h"

namespace guidelight {
namespace {

/// A lamp of radius ¼ at (0, 2, 0) over a floor at y = 0, and a mirror at x = 2 that faces -x.
std::shared_ptr<const Scene> lamp_floor_and_mirror() {
  auto scene = std::make_shared<SceneDescription>();
  scene->bsdfs.push_back({"chalk", 0, DiffuseBsdf{}});
  scene->bsdfs.push_back({"mirror", 0, ConductorBsdf{}});
  ShapeDescription lamp;
  lamp.name = "lamp";
  lamp.geometry = SphereShape{};
  lamp.to_world = glm::scale(glm::translate(Mat4(1), Vec3(0, 2, 0)), Vec3(0.25f));
  lamp.bsdf = 0;
  lamp.radiance = ColorInput{};
  ShapeDescription floor;
  floor.name = "floor";
  floor.geometry = DiskShape{};
  floor.to_world = glm::scale(glm::rotate(Mat4(1), -kPi / 2, Vec3(1, 0, 0)), Vec3(10));
  floor.bsdf = 0;
  ShapeDescription mirror = floor;
  mirror.name = "mirror";
  mirror.to_world = glm::translate(Mat4(1), Vec3(2, 1, 0)) *
                    glm::scale(glm::rotate(Mat4(1), -kPi / 2, Vec3(0, 1, 0)), Vec3(0.9f));
  mirror.bsdf = 1;
  scene->shapes = {lamp, floor, mirror};
  return Scene::build(scene);
}

SurfacePoint look(const Scene& scene, Vec3 from, Vec3 to) {
  const Ray ray{from, glm::normalize(to - from), kInfinity};
  return scene.surface_point(ray, scene.intersect(ray));
}

class GuideEditing : public ::testing::Test {
 protected:
  LightPlace lamp() const {
    const Vec3 from(0.5f, 1, 3);
    const Ray ray{from, glm::normalize(Vec3(0, 2, 0) - from), kInfinity};
    return *pick_light(*scene, ray, [](Vec3) { return false; });
  }
  SurfacePoint on_floor(float x, float z) const { return look(*scene, {x, 1, z}, {x, 0, z}); }

  const std::shared_ptr<const Scene> scene = lamp_floor_and_mirror();
  static constexpr auto kChoice = SpecularChoice::Refract;
};

TEST_F(GuideEditing, APathGoesStraightToADiffuseSurface) {
  GuideDraft draft;
  draft.begin(*scene, lamp());
  const Continuation next = draft.aim(*scene, on_floor(0.5f, 1.5f), kChoice);
  EXPECT_EQ(next.problem, "");
  draft.add(next);
  const GuidePath path = draft.path();
  EXPECT_EQ(path.vertices.size(), 2u);
  EXPECT_TRUE(check_guide(*scene, path).empty());
  EXPECT_GT(path.disc_radius, 0);
  EXPECT_LT(path.disc_radius, 0.5f);
}

TEST_F(GuideEditing, AMirrorIsFollowedToWhatItShows) {
  GuideDraft draft;
  draft.begin(*scene, lamp());
  const Continuation next = draft.aim(*scene, look(*scene, {0, 1, 1}, {2, 1, 0.3f}), kChoice);
  EXPECT_EQ(next.problem, "");
  ASSERT_EQ(next.vertices.size(), 2u);
  EXPECT_EQ(next.vertices[0].event, PathEvent::Reflect);
  draft.add(next);
  EXPECT_TRUE(check_guide(*scene, draft.path()).empty());
}

TEST_F(GuideEditing, ABlockedSegmentSaysBywhat) {
  GuideDraft draft;
  draft.begin(*scene, lamp());
  const Continuation next = draft.aim(*scene, on_floor(5, 0), kChoice);
  EXPECT_NE(next.problem.find("in the way"), std::string::npos) << next.problem;
}

TEST_F(GuideEditing, AVertexBehindAMirrorStaysWhereItIsPut) {
  GuideDraft draft;
  draft.begin(*scene, lamp());
  draft.add(draft.aim(*scene, look(*scene, {0, 1, 1}, {2, 1, 0.3f}), kChoice));
  const GuidePath before = draft.path();
  const Vec3 end = before.vertices[2].position;
  const SurfacePoint to = on_floor(end.x + 0.1f, end.z + 0.15f);
  const GuidePath after = move_guide_vertex(*scene, before, 2, to);
  ASSERT_EQ(after.vertices.size(), 3u);
  EXPECT_LT(glm::distance(after.vertices[2].position, to.position), 1e-3f);
  EXPECT_GT(glm::distance(after.vertices[1].position, before.vertices[1].position), 1e-3f);
  EXPECT_TRUE(check_guide(*scene, after).empty());
}

TEST_F(GuideEditing, AMirrorVertexTakesTheRestAlong) {
  GuideDraft draft;
  draft.begin(*scene, lamp());
  draft.add(draft.aim(*scene, look(*scene, {0, 1, 1}, {2, 1, 0.3f}), kChoice));
  const GuidePath after =
      move_guide_vertex(*scene, draft.path(), 1, look(*scene, {0, 1, 1}, {2, 0.8f, 0.1f}));
  EXPECT_TRUE(check_guide(*scene, after).empty());
  EXPECT_GT(glm::distance(after.vertices[2].position, draft.path().vertices[2].position), 0.1f);
}

TEST_F(GuideEditing, TheFirstVertexStaysOnALight) {
  GuideDraft draft;
  draft.begin(*scene, lamp());
  draft.add(draft.aim(*scene, on_floor(0.5f, 1.5f), kChoice));
  const GuidePath after = move_guide_vertex(*scene, draft.path(), 0, on_floor(1, 1));
  EXPECT_EQ(after.vertices[0].position, draft.path().vertices[0].position);
}

TEST_F(GuideEditing, CandidatesOfANarrowConeArriveAndOthersAreCounted) {
  GuideDraft draft;
  draft.begin(*scene, lamp());
  draft.add(draft.aim(*scene, on_floor(0.5f, 1.5f), kChoice));
  GuidePath path = draft.path();
  const GuideCandidates narrow = sample_candidates(scene, path, 50);
  ASSERT_EQ(narrow.candidates.size(), 50u);
  EXPECT_GT(narrow.valid_share(), 0.8f);
  path.vertices[0].cone = kPi / 2;
  EXPECT_LT(sample_candidates(scene, path, 50).valid_share(), narrow.valid_share());
}

TEST(UndoStack, StepsOfOneKindMergeUntilSealed) {
  UndoStack<int> stack(0);
  stack.commit(1, "drag", "drag");
  stack.commit(2, "drag", "drag");
  stack.seal();
  stack.commit(3, "drag", "drag");
  EXPECT_TRUE(stack.undo());
  EXPECT_EQ(stack.state(), 2);
  EXPECT_EQ(stack.redo_label(), "drag");
  EXPECT_TRUE(stack.undo());
  EXPECT_EQ(stack.state(), 0);
  EXPECT_FALSE(stack.undo());
  EXPECT_TRUE(stack.redo());
  stack.commit(9, "other");
  EXPECT_FALSE(stack.redo()) << "a new step forgets what was undone";
  EXPECT_EQ(stack.undo_label(), "other");
}

}  // namespace
}  // namespace guidelight

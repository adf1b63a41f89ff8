#include "tests/renderer/transport/guide_scenes.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "renderer/sampling/random.h"
#include "renderer/sampling/warp.h"
#include "renderer/transport/guide_check.h"
#include "renderer/transport/guide_trace.h"

namespace guidelight::guide_test {

namespace {

const Color kRadiance(6, 5, 4);

template <typename Model>
void add_guide_emitter(SceneDescription& scene, Model model) {
  scene.emitters.push_back({.name = "", .line = 0, .model = model});
}

Mat4 facing_down(Vec3 position, float scale) {
  const Mat4 turned =
      glm::rotate(glm::translate(Mat4(1), position), glm::radians(90.0f), Vec3(1, 0, 0));
  return glm::scale(turned, Vec3(scale));
}

void add_rectangle_light(SceneDescription& scene) {
  testing::add_rectangle(scene, facing_down({0, 0.9f, 0}, 0.3f), 0).radiance =
      ColorInput{kRadiance};
}

void add_sphere_light(SceneDescription& scene) {
  testing::add_sphere(scene, {0, 0.9f, 0}, 0.15f, 0).radiance = ColorInput{20.0f * kRadiance};
}

/// A lid hides a part of the light from below, where discs are projected from.
void add_covered_light(SceneDescription& scene) {
  add_sphere_light(scene);
  testing::add_rectangle(scene, facing_down({0.16f, 0.77f, 0}, 0.08f), 0);
}

Mat4 spot_transform() {
  // Looks down along its z.
  return glm::rotate(glm::translate(Mat4(1), Vec3(0, 0.9f, 0)), glm::radians(90.0f), Vec3(1, 0, 0));
}

void add_projector(SceneDescription& scene) {
  auto image = std::make_shared<Image>(4, 4, 3);
  for (int i = 0; i < 48; ++i) image->data()[i] = 1 + 0.3f * static_cast<float>(i * i % 5);
  add_guide_emitter(scene, ProjectorEmitter{spot_transform(), image, 1.4f, 3});
}

void add_environment(SceneDescription& scene) {
  auto image = std::make_shared<Image>(8, 4, 3);
  for (int i = 0; i < 96; ++i) image->data()[i] = 0.2f + 0.5f * static_cast<float>(i * i % 7);
  add_guide_emitter(scene, EnvironmentEmitter{image, Mat4(1), 1});
}

void add_sun(SceneDescription& scene) {
  SunSkyEmitter sun;
  sun.sky = false;
  sun.sun_direction = {0.1f, 1, 0.2f};
  sun.sun_radius_scale = 60;
  add_guide_emitter(scene, sun);
}

}  // namespace

const std::vector<LitScene>& lit_scenes() {
  static const std::vector<LitScene> list = {
      {"rectangle", add_rectangle_light, {0.1f, 0.9f, 0}},
      {"sphere", add_sphere_light, {0, 0.75f, 0}},
      {"covered_sphere", add_covered_light, {0, 0.75f, 0}},
      {"point",
       [](SceneDescription& scene) {
         add_guide_emitter(scene, PointEmitter{{0, 0.9f, 0}, kRadiance});
       },
       {0, 0.9f, 0}},
      {"spot",
       [](SceneDescription& scene) {
         SpotEmitter spot;
         spot.to_world = spot_transform();
         spot.intensity = kRadiance;
         spot.cutoff_angle = 0.9f;
         spot.beam_width = 0.5f;
         add_guide_emitter(scene, spot);
       },
       {0, 0.9f, 0}},
      {"projector", add_projector, {0, 0.9f, 0}},
      {"directional",
       [](SceneDescription& scene) {
         add_guide_emitter(scene, DirectionalEmitter{{-0.1f, -1, -0.2f}, kRadiance});
       },
       {}},
      {"constant",
       [](SceneDescription& scene) { add_guide_emitter(scene, ConstantEmitter{kRadiance}); },
       {}},
      {"environment", add_environment, {}},
      {"sun", add_sun, {}},
  };
  return list;
}

SceneDescription LitScene::describe(int side) const {
  SceneDescription scene = testing::empty_scene(side, side);
  const int white = testing::add_diffuse(scene, Color(0.7f, 0.6f, 0.5f));
  DielectricBsdf glass;
  scene.bsdfs.push_back({.name = "glass", .line = 0, .model = glass});
  testing::add_rectangle(
      scene,
      glm::rotate(glm::translate(Mat4(1), Vec3(0, -1, 0)), glm::radians(-90.0f), Vec3(1, 0, 0)),
      white);
  testing::add_rectangle(scene, glm::translate(Mat4(1), Vec3(0, 0, -1)), white);
  testing::add_sphere(scene, kBall, 0.35f, white + 1);
  add_light(scene);
  testing::look_at(scene, {0, 0.2f, 2.6f}, {0, -0.6f, 0});
  return scene;
}

namespace {

/// Where a path towards a target begins.
Vec3 start_towards(const Scene& scene, const LitScene& lit, Vec3 target) {
  const Light& light = *scene.lights()[0];
  return light.is_infinite() ? target + 3.0f * glm::normalize(Vec3(0.1f, 1, 0.2f)) : lit.start;
}

void add_guide(const Scene& scene, const LitScene& lit, std::vector<Vec3> targets,
               std::vector<GuidePath>& guides) {
  auto guide = trace_guide_through(scene, start_towards(scene, lit, targets[0]), targets);
  ASSERT_TRUE(guide) << lit.name;
  guide->disc_radius = 0.2f;
  for (GuideVertex& vertex : guide->vertices) vertex.cone = 0.4f;
  guides.push_back(*guide);
}

}  // namespace

std::vector<GuidePath> guides_for(const Scene& scene, const LitScene& lit) {
  std::vector<GuidePath> guides;
  add_guide(scene, lit, {kTarget}, guides);
  add_guide(scene, lit, {{-0.3f, -0.4f, -1}, kTarget}, guides);
  add_guide(scene, lit, {kBall}, guides);
  add_guide(scene, lit, {{-0.2f, -1, 0.6f}, {-0.5f, 0.1f, -1}}, guides);
  guides[0].weight = 2;
  guides[2].vertices[0].cone = 0.15f;
  guides[3].disc_radius = 0.5f;  // larger than the lamps
  return guides;
}

std::vector<GuidePath> random_guides(const Scene& scene, const LitScene& lit, int count) {
  std::vector<GuidePath> guides;
  Rng rng(17, 0, 0);
  while (static_cast<int>(guides.size()) < count) {
    const Vec3 target(2 * rng.next_float() - 1, -1, 2 * rng.next_float() - 1);
    const Vec3 next(2 * rng.next_float() - 1, rng.next_float() - 0.5f, -1);
    const Vec3 start = start_towards(scene, lit, target);
    auto guide = trace_guide_through(scene, start, std::vector<Vec3>{target, next});
    if (!guide || !check_guide(scene, *guide).empty()) continue;
    guide->disc_radius = 0.02f + 0.2f * rng.next_float();
    for (GuideVertex& vertex : guide->vertices) vertex.cone = 0.02f + 0.4f * rng.next_float();
    guides.push_back(*guide);
  }
  return guides;
}

}  // namespace guidelight::guide_test
